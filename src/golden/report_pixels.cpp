#include "golden/report_pixels.hpp"

#include "compare/align.hpp"
#include "core/error.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/gtc/packing.hpp>
#include <nlohmann/json.hpp>
#include <zlib.h>

namespace sr::golden {
namespace {

/// 2^k that brings the largest finite magnitude to [2^14, 2^15): halves end at 65504.
float scale_of(const image::Image& image) {
    float largest = 0.0f;
    for (const float value : image.pixels)
        if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
    return largest > 0.0f ? std::ldexp(1.0f, std::clamp(14 - std::ilogb(largest), -120, 120)) : 1.0f;
}

std::string byte_planes(const image::Image& image, float scale) {
    const std::size_t count = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    const auto stride = static_cast<std::size_t>(image.channels);
    const auto channels = compare::color_channels(image);
    std::string planes(6 * count, '\0');
    for (std::size_t c = 0; c < 3; ++c)
        for (std::size_t i = 0; i < count; ++i) {
            const std::uint16_t half = glm::packHalf1x16(image.pixels[i * stride + channels[c]] * scale);
            planes[2 * c * count + i] = static_cast<char>(half >> 8);
            planes[(2 * c + 1) * count + i] = static_cast<char>(half & 0xFF);
        }
    return planes;
}

std::string deflated(const std::string& bytes) {
    uLongf size = compressBound(bytes.size());
    std::string result(size, '\0');
    const int status =
        compress2(reinterpret_cast<Bytef*>(result.data()), &size,
                  reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(), Z_BEST_COMPRESSION);
    require(status == Z_OK, "zlib compresses into a buffer of its own bound");
    result.resize(size);
    return result;
}

} // namespace

nlohmann::ordered_json packed_pixels(const image::Image& image) {
    const float scale = scale_of(image);
    return {{"width", image.width},
            {"height", image.height},
            {"scale", scale},
            {"data", base64(deflated(byte_planes(image, scale)))}};
}

std::string base64(std::string_view bytes) {
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k)
            group = group << 8 | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        for (std::size_t k = 0; k < 4; ++k) text += k <= count ? digits[group >> (18 - 6 * k) & 63] : '=';
    }
    return text;
}

} // namespace sr::golden
