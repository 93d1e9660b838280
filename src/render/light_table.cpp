#include "render/light_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace sr::render {
namespace {

enum Kind { point_light, spot_light, directional_light, rectangle_light };

using Texels = std::array<vec4, texels_per_light>;

float inverse_range(float range) { return std::isfinite(range) ? 1.0f / range : 0.0f; }

Texels packed(const scene::PointLight& light) {
    Texels t{};
    t[0] = vec4(light.position, point_light);
    t[1].w = inverse_range(light.range);
    t[2] = vec4(light.I, 0.0f);
    return t;
}

Texels packed(const scene::SpotLight& light) {
    Texels t{};
    t[0] = vec4(light.position, spot_light);
    t[1] = vec4(light.direction, inverse_range(light.range));
    // KHR_lights_punctual, "Inner and Outer Cone Angles"; 0.001 is the extension's guard against a hard edge.
    const float cos_outer = std::cos(light.outer_angle);
    const float scale = 1.0f / std::max(0.001f, std::cos(light.inner_angle) - cos_outer);
    t[2] = vec4(light.I, scale);
    t[3].w = -cos_outer * scale;
    return t;
}

Texels packed(const scene::DirectionalLight& light) {
    Texels t{};
    t[0].w = directional_light;
    t[1] = vec4(light.direction, 0.0f);
    t[2] = vec4(light.E, 0.0f);
    return t;
}

Texels packed(const scene::RectangleLight& light) {
    Texels t{};
    t[0] = vec4(light.center, rectangle_light);
    t[1] = vec4(light.normal(), 0.0f);
    t[2] = vec4(light.L, 0.0f);
    t[3] = vec4(light.half_u, 0.0f);
    t[4] = vec4(light.half_v, light.is_two_sided ? 1.0f : 0.0f);
    return t;
}

} // namespace

std::vector<vec4> pack_lights(std::span<const scene::Light> lights) {
    std::vector<vec4> table;
    table.reserve(lights.size() * texels_per_light);
    for (const scene::Light& light : lights) {
        const Texels texels = std::visit([](const auto& any) { return packed(any); }, light);
        table.insert(table.end(), texels.begin(), texels.end());
    }
    return table;
}

} // namespace sr::render
