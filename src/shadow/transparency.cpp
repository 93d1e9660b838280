#include "shadow/transparency.hpp"

#include "image/display.hpp"

#include <algorithm>
#include <cmath>

namespace sr::shadow {
namespace {

float schlick_weight(float cos_w) {
    const float m = glm::clamp(1.0f - cos_w, 0.0f, 1.0f);
    return m * m * m * m * m;
}

} // namespace

GlassPoint glass_at(const Glass& glass, std::span<const GlassCorner, 3> corners, vec3 weights,
                    const std::vector<AlphaMap>& maps, const std::vector<std::uint16_t>& texels) {
    const auto mean = [&](auto member) {
        return weights.x * member(corners[0]) + weights.y * member(corners[1])
               + weights.z * member(corners[2]);
    };
    const auto read = [&](int map, std::size_t uv_set, int plane) {
        if (map < 0) return 1.0f;
        AlphaMap chosen = maps[static_cast<std::size_t>(map)];
        chosen.first += plane * chosen.width * chosen.height;
        return map_alpha(chosen, texels, mean([uv_set](const GlassCorner& c) { return c.uv[uv_set]; }));
    };
    vec4 color = mean([](const GlassCorner& c) { return c.color; });
    for (int plane = 0; plane < 4; ++plane) color[plane] *= read(glass.base_map, 0, plane);
    const float t = glass.transmission * read(glass.transmission_map, 1, 0);
    const float metallic = glass.metallic * read(glass.metallic_map, 3, 0);
    return {(1.0f - metallic) * t * vec3(color), color.w, read(glass.thickness_map, 2, 0)};
}

vec3 straight_transmittance(const Glass& glass, const GlassPoint& point, vec3 n, vec3 w) {
    const float towards = glm::dot(n, w);
    const float weight =
        schlick_weight(std::abs(towards) * glm::inversesqrt(glm::dot(n, n) * glm::dot(w, w)));
    const float F = glass.specular * glm::mix(glass.F0, 1.0f, weight);
    const float F_coat = glass.clearcoat * glm::mix(0.04f, 1.0f, weight);
    const bool leaves_body = glass.is_body && towards * glass.front > 0.0f;
    const vec3 optical_depth = leaves_body ? vec3(0.0f) : glass.optical_depth * point.thickness;
    return point.color * ((1.0f - F) * (1.0f - F_coat)) * glm::exp(-optical_depth);
}

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
