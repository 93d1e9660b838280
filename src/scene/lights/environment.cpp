#include "scene/lights/environment.hpp"

#include <cmath>

namespace sr::scene {
namespace {

/// Uniform over the unit sphere, (0, 0) its uppermost point.
vec3 on_sphere(vec2 u) {
    const float across = 2.0f * std::sqrt(u.y * (1.0f - u.y));
    return {across * std::cos(2.0f * pi * u.x), 1.0f - 2.0f * u.y, across * std::sin(2.0f * pi * u.x)};
}

EmitterPoint far_point(vec3 direction) {
    EmitterPoint point{direction};
    point.is_far = true;
    return point;
}

} // namespace

mat3 EnvironmentLight::map_from_world() const {
    const float c = std::cos(rotation), s = std::sin(rotation);
    return {vec3(c, 0.0f, s), vec3(0.0f, 1.0f, 0.0f), vec3(-s, 0.0f, c)}; // columns: around +Y by -rotation
}

std::optional<double> EnvironmentLight::quantity_from(Quantity quantity, double value) const {
    return quantity == Quantity::radiance ? std::optional(value) : std::nullopt;
}

void EnvironmentLight::transform(const Motion& by) {
    rotation += std::atan2(by.rotation[2].x, by.rotation[2].z);
}

EmitterPoint EnvironmentLight::sample_point(vec3 u) const {
    return far_point(glm::normalize(map && map->has_light() ? map->sample(vec2(u)) * map_from_world()
                                                            : on_sphere(vec2(u))));
}

EmitterPoint EnvironmentLight::middle() const { return far_point(vec3(0.0f, 1.0f, 0.0f)); }

} // namespace sr::scene
