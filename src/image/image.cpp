#include "image/image.hpp"

#include "core/error.hpp"

#include <algorithm>
#include <cmath>

namespace sr::image {

Image::Image(int image_width, int image_height, int channel_count)
    : width(image_width), height(image_height), channels(channel_count) {
    require(width > 0 && height > 0 && channels > 0, "an image has a positive size");
    pixels.resize(offset(0, height));
}

double relative_floor(std::vector<float> colors) {
    std::erase(colors, 0.0f);
    if (colors.empty()) return 0.0;
    for (float& color : colors) color = std::abs(color);
    const auto middle = colors.begin() + static_cast<std::ptrdiff_t>(colors.size() / 2);
    std::ranges::nth_element(colors, middle);
    return 0.01 * static_cast<double>(*middle);
}

double relative_square(double difference, double reference, double floor) {
    if (difference == 0.0) return 0.0;
    return difference * difference / (reference * reference + floor * floor);
}

Image as_rgb(const Image& image) {
    Image rgb(image.width, image.height, 3);
    const std::size_t step = static_cast<std::size_t>(image.channels);
    const float* from = image.pixels.data();
    for (std::size_t i = 0; i < rgb.pixels.size(); i += 3, from += step)
        for (std::size_t c = 0; c < 3; ++c) rgb.pixels[i + c] = from[step >= 3 ? c : 0];
    return rgb;
}

std::vector<std::uint8_t> as_bytes(const std::vector<float>& values) {
    std::vector<std::uint8_t> bytes(values.size());
    std::ranges::transform(values, bytes.begin(), [](float value) {
        const float inside = value > 0.0f ? std::min(value, 1.0f) : 0.0f; // NaN too becomes 0
        return static_cast<std::uint8_t>(inside * 255.0f + 0.5f);
    });
    return bytes;
}

} // namespace sr::image
