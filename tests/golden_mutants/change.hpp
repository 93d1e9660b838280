#pragma once
// Ways to change an image.
#include "image/image.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>

namespace sr::testing {

/// `f(value)` of R, G and B (alpha and layers stay).
template<typename Function>
image::Image with_colors(image::Image image, const Function& f) {
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            for (float& value : image.at(x, y).first(3)) value = f(value);
    return image;
}

inline image::Image scaled(const image::Image& image, float factor) {
    return with_colors(image, [factor](float value) { return factor * value; });
}

/// `f(x, y)` says from which pixel of the image each pixel of the result comes; outside it is black.
template<typename Function>
image::Image rearranged(const image::Image& image, const Function& f) {
    image::Image result = image;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const auto [from_x, from_y] = f(x, y);
            const auto to = result.at(x, y);
            const bool is_inside =
                from_x >= 0 && from_y >= 0 && from_x < image.width && from_y < image.height;
            if (is_inside)
                std::ranges::copy(image.at(from_x, from_y), to.begin());
            else
                std::ranges::fill(to, 0.0f);
        }
    return result;
}

/// R, G and B taken from the given channels.
inline image::Image reordered(image::Image image, std::array<std::size_t, 3> order) {
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const auto pixel = image.at(x, y);
            const std::array from{pixel[order[0]], pixel[order[1]], pixel[order[2]]};
            std::ranges::copy(from, pixel.begin());
        }
    return image;
}

/// The same random numbers on every machine: mt19937 is fixed by the standard, its distributions are not.
class Random {
public:
    explicit Random(std::uint32_t seed) : engine_(seed) {}
    /// In [0, 1).
    float uniform() { return static_cast<float>(engine_() >> 8) * 0x1p-24f; }
    /// Nearly normal, of mean 0 and variance 1: the sum of twelve uniform numbers, which ends at 6.
    float normal() {
        float sum = -6.0f;
        for (int i = 0; i < 12; ++i) sum += uniform();
        return sum;
    }

private:
    std::mt19937 engine_;
};

} // namespace sr::testing
