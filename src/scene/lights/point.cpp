#include "scene/lights/point.hpp"

#include "scene/lights/shapes.hpp"

namespace sr::scene {

std::optional<double> PointLight::quantity_from(Quantity quantity, double value) const {
    if (quantity == Quantity::flux) return value / (4.0 * pi64);
    if (quantity == Quantity::intensity) return value;
    if (quantity == Quantity::radiance && radius > 0.0f)
        return value * pi64 * double{radius} * double{radius};
    return std::nullopt;
}

vec3 PointLight::flux(const std::vector<LightProfile>& profiles) const {
    const double times = profile < 0 ? 4.0 * pi64 : flux_of(profiles[static_cast<std::size_t>(profile)]);
    return vec3(times * glm::dvec3(I));
}

Bounds PointLight::bounds() const { return box_around(position, vec3(radius)); }

void PointLight::transform(const Motion& by) {
    position = by.place(position);
    world_from_profile = by.rotation * world_from_profile;
    radius *= by.scale;
}

std::optional<LightSurface> PointLight::surface() const {
    if (!is_visible || !(radius > 0.0f) || profile >= 0) return std::nullopt;
    return LightSurface{capsule_mesh(position, vec3(0.0f), radius), I / (pi * radius * radius)};
}

EmitterPoint PointLight::sample_point(vec3 u) const { return in_ball(position, radius, u); }

EmitterPoint PointLight::middle() const { return sample_point(ball_center); }

} // namespace sr::scene
