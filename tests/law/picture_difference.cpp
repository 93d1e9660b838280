#include "picture_difference.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace sr::testing {
namespace {

constexpr float max_relative = 0.01f;

struct Range {
    float low = INFINITY, high = -INFINITY;
};

/// The values of a pixel and its neighbours.
Range range_around(const image::Image& picture, int column, int row, int channel) {
    Range range;
    for (int y = std::max(row - 1, 0); y <= std::min(row + 1, picture.height - 1); ++y)
        for (int x = std::max(column - 1, 0); x <= std::min(column + 1, picture.width - 1); ++x) {
            range.low = std::min(range.low, picture.at(x, y)[channel]);
            range.high = std::max(range.high, picture.at(x, y)[channel]);
        }
    return range;
}

bool is_within(float value, const Range& range, float floor) {
    const float slack = max_relative * std::abs(range.high) + floor;
    return value >= range.low - slack && value <= range.high + slack;
}

/// Returns the radiance that counts as black: a thousandth of the mean.
float floor_of(const image::Image& picture) {
    double sum = 0.0;
    for (std::size_t i = 0; i < picture.pixels.size(); ++i)
        sum += i % 4 == 3 ? 0.0 : std::abs(picture.pixels[i]);
    return static_cast<float>(1e-3 * sum / static_cast<double>(picture.pixels.size()) + 1e-30);
}

bool are_alike(float a, float b, float floor) {
    return std::abs(a - b) <= max_relative * std::max(std::abs(a), std::abs(b)) + floor;
}

} // namespace

Difference difference_of(const image::Image& a, const image::Image& b) {
    const float floor = floor_of(a);
    Difference difference;
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x) {
            bool is_moved = false, is_strange = false;
            for (int i = 0; i < 4; ++i) {
                const float va = a.at(x, y)[i], vb = b.at(x, y)[i];
                if (are_alike(va, vb, floor)) continue;
                is_moved = true;
                if (is_within(va, range_around(b, x, y, i), floor)
                    && is_within(vb, range_around(a, x, y, i), floor))
                    continue;
                if (!is_strange && difference.first.empty())
                    difference.first = fmt::format("({}, {})[{}]: {} and {}", x, y, i, va, vb);
                is_strange = true;
            }
            difference.moved += is_moved;
            difference.strange += is_strange;
        }
    return difference;
}

image::Image in_a_mirror(const image::Image& picture) {
    image::Image result = picture;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            for (int i = 0; i < 4; ++i) result.at(x, y)[i] = picture.at(picture.width - 1 - x, y)[i];
    return result;
}

} // namespace sr::testing
