#include "compare/pictures.hpp"

#include "compare/align.hpp"
#include "core/math.hpp"
#include "image/colormap.hpp"
#include "image/display.hpp"

#include <algorithm>
#include <cmath>

namespace sr::compare {
namespace {

using image::Image;
using image::nonfinite_color;

constexpr vec3 excluded_color{0.13f, 0.15f, 0.2f};

vec3 error_color(float error) {
    if (std::isnan(error)) return nonfinite_color;
    if (error < 0.0f) return excluded_color;
    constexpr float decades = 2.0f; // to each side of the limit
    return image::colormap(0.5f + std::log10(std::max(error, 1e-30f)) / (2.0f * decades));
}

/// The layer in question, for a screen.
Image shown(const Image& image, const CompareOptions& options, float ev100) {
    const auto layer = layer_of(image, options.layer);
    const Image colors = layer ? extract(image, layer->colors) : Image(image.width, image.height, 1);
    if (options.encoding == Encoding::scene_referred) return image::displayed(colors, ev100);
    Image codes(colors.width, colors.height, 3);
    for (std::size_t i = 0; i < codes.pixels.size() / 3; ++i)
        for (std::size_t c = 0; c < 3; ++c) {
            const auto channels = static_cast<std::size_t>(colors.channels);
            const float value = colors.pixels[i * channels + std::min(c, channels - 1)];
            const bool is_finite = std::isfinite(value);
            codes.pixels[3 * i + c] =
                is_finite ? std::clamp(value, 0.0f, 1.0f) : nonfinite_color[static_cast<int>(c)];
        }
    return codes;
}

float exposure_of(const Image& reference, const CompareOptions& options) {
    const auto layer = layer_of(reference, options.layer);
    return layer ? image::auto_ev100(extract(reference, layer->colors)) : 0.0f;
}

void paste(Image& onto, const Image& picture, int left) {
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            std::ranges::copy(picture.at(x, y), onto.at(left + x, y).begin());
}

} // namespace

Image heat_map(const Comparison& comparison) {
    const Image& error = comparison.error;
    if (error.pixels.empty()) { // nothing could be compared
        Image none(1, 1, 3);
        for (int c = 0; c < 3; ++c) none.at(0, 0)[static_cast<std::size_t>(c)] = nonfinite_color[c];
        return none;
    }
    Image map(error.width, error.height, 3);
    for (std::size_t i = 0; i < error.pixels.size(); ++i) {
        const vec3 color = error_color(error.pixels[i]);
        for (int c = 0; c < 3; ++c) map.pixels[3 * i + static_cast<std::size_t>(c)] = color[c];
    }
    return map;
}

Image side_by_side(const Image& test, const Image& reference, const Comparison& comparison,
                   const CompareOptions& options) {
    constexpr int gap = 4; // [pixels]
    const float ev100 = exposure_of(reference, options);
    const Image left = shown(test, options, ev100), middle = shown(reference, options, ev100);
    const Image right = heat_map(comparison);
    Image all(left.width + middle.width + right.width + 2 * gap,
              std::max({left.height, middle.height, right.height}), 3);
    std::ranges::fill(all.pixels, 0.5f);
    paste(all, left, 0);
    paste(all, middle, left.width + gap);
    paste(all, right, left.width + middle.width + 2 * gap);
    return all;
}

} // namespace sr::compare
