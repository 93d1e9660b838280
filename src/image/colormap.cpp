#include "image/colormap.hpp"

#include "core/error.hpp"
#include "core/math.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace sr::image {

vec3 colormap(float place) {
    constexpr auto last = static_cast<float>(viridis.size() - 1);
    const float at = std::clamp(place, 0.0f, 1.0f) * last;
    const auto i = static_cast<std::size_t>(std::min(at, last - 1.0f));
    return glm::mix(viridis[i], viridis[i + 1], at - static_cast<float>(i));
}

std::string colormap_glsl() {
    std::string text = fmt::format("const vec3 colormap_colors[{0}] = vec3[{0}](", viridis.size());
    for (const vec3& color : viridis)
        text += fmt::format("vec3({:#.9g}, {:#.9g}, {:#.9g}),", color.r, color.g, color.b);
    text.pop_back();
    return text + ");\n";
}

vec3 luminance_color(float luminance, const Decades& decades) {
    if (!std::isfinite(luminance)) return nonfinite_color;
    constexpr float min_luminance = 1e-30f; // keeps the logarithm finite
    return colormap((std::log10(std::max(luminance, min_luminance)) - decades.first)
                    / (decades.last - decades.first));
}

Image luminance_colors(const Image& film) {
    require(film.channels >= 3, "a film has colours");
    Image colors(film.width, film.height, 3);
    for (int y = 0; y < film.height; ++y) {
        for (int x = 0; x < film.width; ++x) {
            const auto L = film.at(x, y);
            const vec3 color = luminance_color(luminance(L[0], L[1], L[2]));
            for (int c = 0; c < 3; ++c) colors.at(x, y)[static_cast<std::size_t>(c)] = color[c];
        }
    }
    return colors;
}

} // namespace sr::image
