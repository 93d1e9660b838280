#include "scene/lights/punctual.hpp"

#include "scene/lights/emitter.hpp"

#include <cmath>

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

namespace {

constexpr double min_ramp = 1e-6; // of cosθ, which 32-bit cosines can distinguish

} // namespace

ConeFalloff SpotLight::falloff() const {
    const double cos_outer = std::cos(double{outer_angle});
    const double scale = 1.0 / std::max(min_ramp, std::cos(double{inner_angle}) - cos_outer);
    return {static_cast<float>(scale), static_cast<float>(-cos_outer * scale)};
}

double SpotLight::solid_angle() const {
    const double cos_outer = std::cos(double{outer_angle});
    const double w = std::max(min_ramp, std::cos(double{inner_angle}) - cos_outer);
    const double rise = std::min(w, 1.0 - cos_outer); // a cone narrower than the ramp ends before the plateau
    return 2.0 * pi64 * ((1.0 - cos_outer - rise) + rise * rise * rise / (3.0 * w * w));
}

std::optional<double> SpotLight::quantity_from(Quantity quantity, double value) const {
    if (quantity == Quantity::flux) return value / solid_angle();
    if (quantity == Quantity::intensity) return value;
    if (quantity == Quantity::radiance && radius > 0.0f)
        return value * pi64 * double{radius} * double{radius};
    return std::nullopt;
}

vec3 SpotLight::flux(const std::vector<LightProfile>&) const { return vec3(solid_angle() * glm::dvec3(I)); }

Bounds SpotLight::bounds() const { return box_around(position, vec3(radius)); }

void SpotLight::transform(const Motion& by) {
    position = by.place(position);
    direction = glm::normalize(by.rotation * direction);
    radius *= by.scale;
}

EmitterPoint SpotLight::sample_point(vec3 u) const { return in_ball(position, radius, u); }

EmitterPoint SpotLight::middle() const { return sample_point(ball_center); }

std::optional<double> DirectionalLight::quantity_from(Quantity quantity, double value) const {
    if (quantity == Quantity::irradiance) return value;
    const double sine = std::sin(double{angular_radius});
    if (quantity == Quantity::radiance && angular_radius > 0.0f) return pi64 * value * sine * sine;
    return std::nullopt;
}

EmitterPoint DirectionalLight::sample_point(vec3 u) const {
    const float half_sine = std::sin(0.5f * angular_radius);
    const float height = 2.0f * half_sine * half_sine * u.y; // 1 - cosθ
    const float across = std::sqrt(height * (2.0f - height));
    const vec3 local(across * std::cos(2.0f * pi * u.x), across * std::sin(2.0f * pi * u.x), 1.0f - height);
    EmitterPoint point{glm::normalize(frame_around(-direction) * local)};
    point.is_far = true;
    return point;
}

} // namespace sr::scene
