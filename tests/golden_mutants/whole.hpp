#pragma once
// Changes of a whole image: moved by parts of a pixel, resampled, with another curve.
#include "golden_mutants/change.hpp"

#include <cmath>

namespace sr::testing {

/// The image read between pixels, dx and dy to the left and above; border pixels repeat outside.
inline image::Image moved(const image::Image& image, float dx, float dy) {
    image::Image result = image;
    const auto clamped = [](int value, int end) { return std::clamp(value, 0, end - 1); };
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const float u = static_cast<float>(x) - dx, v = static_cast<float>(y) - dy;
            const int left = static_cast<int>(std::floor(u)), top = static_cast<int>(std::floor(v));
            const float s = u - static_cast<float>(left), t = v - static_cast<float>(top);
            for (std::size_t c = 0; c < static_cast<std::size_t>(image.channels); ++c) {
                const auto at = [&](int i, int j) {
                    return image.at(clamped(left + i, image.width), clamped(top + j, image.height))[c];
                };
                result.at(x, y)[c] = (1.0f - t) * ((1.0f - s) * at(0, 0) + s * at(1, 0))
                                     + t * ((1.0f - s) * at(0, 1) + s * at(1, 1));
            }
        }
    return result;
}

/// Rendered at half the size and enlarged again: each 2×2 pixels become their mean.
inline image::Image at_half_resolution(image::Image image) {
    for (int y = 0; y + 1 < image.height; y += 2)
        for (int x = 0; x + 1 < image.width; x += 2)
            for (std::size_t c = 0; c < static_cast<std::size_t>(image.channels); ++c) {
                const float mean = (image.at(x, y)[c] + image.at(x + 1, y)[c] + image.at(x, y + 1)[c]
                                    + image.at(x + 1, y + 1)[c])
                                   / 4.0f;
                for (int k = 0; k < 4; ++k) image.at(x + k % 2, y + k / 2)[c] = mean;
            }
    return image;
}

/// A file of half the size.
inline image::Image of_half_size(const image::Image& image) {
    image::Image result(image.width / 2, image.height / 2, image.channels);
    result.channel_names = image.channel_names;
    const image::Image means = at_half_resolution(image);
    for (int y = 0; y < result.height; ++y)
        for (int x = 0; x < result.width; ++x)
            std::ranges::copy(means.at(2 * x, 2 * y), result.at(x, y).begin());
    return result;
}

/// Only `steps` values of each unit are left.
inline image::Image banded(const image::Image& image, float steps) {
    return with_colors(image, [steps](float value) { return std::round(value * steps) / steps; });
}

inline image::Image with_gamma(const image::Image& image, float gamma) {
    return with_colors(image, [gamma](float value) { return std::pow(std::max(value, 0.0f), 1.0f / gamma); });
}

} // namespace sr::testing
