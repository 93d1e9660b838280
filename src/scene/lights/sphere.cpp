#include "scene/lights/sphere.hpp"

#include "scene/lights/emitter.hpp"

namespace sr::scene {

Radiator SphereLight::radiator() const {
    const double disk = pi64 * double{radius} * double{radius};
    return {4.0 * disk, disk};
}

Bounds SphereLight::bounds() const { return box_around(center, vec3(radius)); }

void SphereLight::transform(const Motion& by) {
    center = by.place(center);
    radius *= by.scale;
}

std::optional<LightSurface> SphereLight::surface() const {
    if (!is_visible) return std::nullopt;
    return LightSurface{capsule_mesh(center, vec3(0.0f), radius), L};
}

EmitterPoint SphereLight::sample_point(vec3 u) const { return in_ball(center, radius, u); }

EmitterPoint SphereLight::middle() const { return sample_point(ball_center); }

} // namespace sr::scene
