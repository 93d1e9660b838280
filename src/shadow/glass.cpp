#include "shadow/glass.hpp"

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

} // namespace sr::shadow
