#pragma once
// Statistics of the pixels of a rectangle: extremes, means, and a histogram.
#include "core/math.hpp"
#include "image/image.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace sr::viewer {

/// Pixels from `from` up to the ones before `end`.
struct PixelRectangle {
    glm::ivec2 from{0};
    glm::ivec2 end{0};

    bool operator==(const PixelRectangle&) const = default;
};

/// The rectangle between two pixels, both included, as far as it lies in a picture of this size.
PixelRectangle between(glm::ivec2 a, glm::ivec2 b, glm::ivec2 size);

struct PixelStatistics {
    static constexpr std::size_t bins = 64;

    std::size_t count = 0;      // of finite pixels
    std::size_t not_finite = 0; // pixels with a channel that is infinite or no number
    // Of red, green, blue and luminance:
    glm::dvec4 min{0.0};
    glm::dvec4 max{0.0};
    glm::dvec4 mean{0.0};
    double deviation = 0.0; // standard deviation of luminance
    /// Numbers of pixels by luminance, logarithmic from 10^first to 10^last. What is darker counts in the
    /// first bin, what is brighter in the last.
    std::array<std::size_t, bins> histogram{};
    double first = -3.0;
    double last = 1.0;
};

/// `film`: three channels or more.
PixelStatistics statistics_of(const image::Image& film, const PixelRectangle& rectangle);

} // namespace sr::viewer
