#include "scene/lights/tube.hpp"

#include "scene/lights/emitter.hpp"

#include <cmath>

namespace sr::scene {
namespace {

/// The cylinder's share of the volume.
float cylinder_share(float half_length, float radius) {
    return half_length / (half_length + 2.0f / 3.0f * radius);
}

} // namespace

Radiator TubeLight::radiator() const {
    const double r = radius, h = glm::length(glm::dvec3(half_axis));
    return {4.0 * pi64 * r * (r + h), 4.0 * r * h + pi64 * r * r};
}

Bounds TubeLight::bounds() const { return box_around(center, vec3(radius) + glm::abs(half_axis)); }

void TubeLight::transform(const Motion& by) {
    center = by.place(center);
    half_axis = by.linear * half_axis;
    radius *= by.scale;
}

std::optional<LightSurface> TubeLight::surface() const {
    if (!is_visible) return std::nullopt;
    return LightSurface{capsule_mesh(center, half_axis, radius), L};
}

EmitterPoint TubeLight::sample_point(vec3 u) const {
    const float half_length = glm::length(half_axis);
    const vec3 axis = half_length > 0.0f ? half_axis / half_length : vec3(0, 1, 0);
    const float in_cylinder = cylinder_share(half_length, radius);
    const mat3 frame = frame_around(axis);
    vec3 local;
    if (u.z < in_cylinder) {
        local = vec3(radius * in_disk(vec2(u)), (2.0f * u.z / in_cylinder - 1.0f) * half_length);
    } else { // in one of the halves of the ball that the ends make
        const float z = 2.0f * u.x - 1.0f, across = std::sqrt(1.0f - z * z);
        const float r = radius * std::cbrt(std::min((u.z - in_cylinder) / (1.0f - in_cylinder), 1.0f));
        local = r * vec3(across * std::cos(2.0f * pi * u.y), across * std::sin(2.0f * pi * u.y), z);
        local.z += z < 0.0f ? -half_length : half_length;
    }
    return {center + frame * local};
}

EmitterPoint TubeLight::middle() const {
    return sample_point({0.0f, 0.0f, 0.5f * cylinder_share(glm::length(half_axis), radius)});
}

} // namespace sr::scene
