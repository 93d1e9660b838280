#pragma once
// Noise as a path tracer's: each value has a standard error of its own.
#include "golden_mutants/change.hpp"

namespace sr::testing {

/// Standard errors of R, G and B: 3 % of the value and 0.005; none where nothing is lit.
inline image::Image noise_floor(const image::Image& image) {
    image::Image floor(image.width, image.height, 3);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            for (std::size_t c = 0; c < 3; ++c) {
                const float value = image.at(x, y)[c];
                floor.at(x, y)[c] = value > 0.0f ? 0.03f * value + 0.005f : 0.0f;
            }
    return floor;
}

/// The image with normal noise of the given standard errors, times `strength`.
inline image::Image noisy(image::Image image, const image::Image& floor, std::uint32_t seed,
                          float strength = 1.0f) {
    Random random(seed);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            for (std::size_t c = 0; c < 3; ++c)
                image.at(x, y)[c] += strength * floor.at(x, y)[c] * random.normal();
    return image;
}

} // namespace sr::testing
