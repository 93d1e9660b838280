#include "shadow/alpha.hpp"

#include "image/srgb.hpp"
#include "scene/alpha.hpp"

#include <algorithm>
#include <cmath>

namespace sr::shadow {
namespace {

std::uint16_t widened(std::uint8_t value) { return static_cast<std::uint16_t>(value * 257u); }
std::uint16_t widened(std::uint16_t value) { return value; }

std::uint16_t linear(std::uint16_t code) {
    return static_cast<std::uint16_t>(
        std::lround(image::linear_of_srgb(static_cast<float>(code) / 65535.0f) * 65535.0f));
}

} // namespace

float map_alpha(const AlphaMap& map, const std::vector<std::uint16_t>& texels, vec2 uv) {
    const vec2 at = scene::texel_place(uv, map.width, map.height);
    const vec2 corner = glm::floor(at);
    const vec2 f = at - corner;
    const int column = static_cast<int>(corner.x), row = static_cast<int>(corner.y);
    const auto texel = [&](int i, int j) {
        const int x = scene::wrapped(column + i, map.width, map.wrap_u);
        const int y = scene::wrapped(row + j, map.height, map.wrap_v);
        return static_cast<float>(texels[static_cast<std::size_t>(map.first + y * map.width + x)]) / 65535.0f;
    };
    return glm::mix(glm::mix(texel(0, 0), texel(1, 0), f.x), glm::mix(texel(0, 1), texel(1, 1), f.x), f.y);
}

std::vector<std::uint16_t> channel_of(const scene::TextureImage& image, std::size_t channel, bool is_srgb) {
    std::vector<std::uint16_t> texels;
    std::visit(
        [&](const auto& values) {
            texels.reserve(values.size() / 4);
            for (std::size_t i = channel; i < values.size(); i += 4)
                texels.push_back(is_srgb ? linear(widened(values[i])) : widened(values[i]));
        },
        image.texels);
    return texels;
}

} // namespace sr::shadow
