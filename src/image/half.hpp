#pragma once
// The range of half floats, as .exr stores them on demand.
#include "image/image.hpp"

#include <algorithm>
#include <cmath>

namespace sr::image {

inline constexpr float largest_half = 65504.0f; // IEEE 754 binary16

/// Counts the values of the image beyond ±65504.
inline std::size_t half_overflow_count(const Image& image) {
    return static_cast<std::size_t>(
        std::ranges::count_if(image.pixels, [](float value) { return std::abs(value) > largest_half; }));
}

/// The image with those values at the end of the range. What is no number stays so.
inline Image within_half(Image image) {
    for (float& value : image.pixels)
        if (std::abs(value) > largest_half) value = std::copysign(largest_half, value);
    return image;
}

} // namespace sr::image
