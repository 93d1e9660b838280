#include "shadow/alpha.hpp"

#include "scene/alpha.hpp"

#include <algorithm>
#include <cmath>

namespace sr::shadow {
namespace {

std::uint16_t widened(std::uint8_t value) { return static_cast<std::uint16_t>(value * 257u); }
std::uint16_t widened(std::uint16_t value) { return value; }

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

std::vector<std::uint16_t> alphas_of(const scene::TextureImage& image) {
    std::vector<std::uint16_t> alphas;
    std::visit(
        [&](const auto& values) {
            alphas.reserve(values.size() / 4);
            for (std::size_t i = 3; i < values.size(); i += 4) alphas.push_back(widened(values[i]));
        },
        image.texels);
    return alphas;
}

} // namespace sr::shadow
