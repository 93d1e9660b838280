#include "image/false_color.hpp"

#include "core/error.hpp"
#include "core/math.hpp"
#include "image/luminance.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace sr::image {
namespace {

vec3 color_of(float luminance) {
    if (!std::isfinite(luminance)) return {1.0f, 0.0f, 1.0f};
    const float decades =
        std::log10(std::max(luminance, luminance_scale[0].luminance) / luminance_scale[0].luminance);
    const float last = static_cast<float>(std::size(luminance_scale) - 1);
    const float place = std::min(decades, last);
    const auto i = static_cast<std::size_t>(std::min(place, last - 1.0f));
    const DecadeColor &a = luminance_scale[i], &b = luminance_scale[i + 1];
    return glm::mix(vec3(a.r, a.g, a.b), vec3(b.r, b.g, b.b), place - static_cast<float>(i));
}

} // namespace

Image luminance_colors(const Image& film) {
    require(film.channels >= 3, "a film has colours");
    Image colors(film.width, film.height, 3);
    for (int y = 0; y < film.height; ++y) {
        for (int x = 0; x < film.width; ++x) {
            const auto L = film.at(x, y);
            const vec3 color = color_of(luminance(L[0], L[1], L[2]));
            for (int c = 0; c < 3; ++c) colors.at(x, y)[static_cast<std::size_t>(c)] = color[c];
        }
    }
    return colors;
}

} // namespace sr::image
