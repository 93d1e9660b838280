#pragma once
// Two images made comparable: the same channels, and which pixels count.
#include "golden/compare.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace sr::golden {

/// Why a pixel counts or does not.
enum class Pixel : std::uint8_t { compared, excluded, nonfinite };

struct Pair {
    image::Image test; // colours, then alpha where both have it; equal to `reference` where not compared
    image::Image reference;
    int colors = 0; // 1 or 3
    std::vector<Pixel> pixels;
    std::vector<std::size_t> compared; // indices of the pixels that are
    std::size_t nonfinite_test = 0;
    std::size_t nonfinite_reference = 0;

    /// The channels of one pixel by its index, y * width + x.
    std::span<const float> test_at(std::size_t pixel) const { return channels_at(test, pixel); }
    std::span<const float> reference_at(std::size_t pixel) const { return channels_at(reference, pixel); }

private:
    static std::span<const float> channels_at(const image::Image& image, std::size_t pixel) {
        const auto channels = static_cast<std::size_t>(image.channels);
        return {image.pixels.data() + pixel * channels, channels};
    }
};

/// What keeps two images from being compared ("the test is 64 x 64, the reference 64 x 32"); empty if
/// nothing.
/// @throws Error if the reference does not have the layer.
std::string obstacle(const image::Image& test, const image::Image& reference, const std::string& layer);

/// The two images as a pair; there must be no obstacle.
/// @throws Error if the region lies outside or the mask has another size, or if they leave no pixel.
Pair paired(const image::Image& test, const image::Image& reference, const CompareOptions& options);

} // namespace sr::golden
