#include "scene/lights/spot.hpp"

#include "scene/lights/shapes.hpp"

#include <cmath>

namespace sr::scene {
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

} // namespace sr::scene
