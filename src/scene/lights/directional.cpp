#include "scene/lights/directional.hpp"

#include "scene/lights/shapes.hpp"

#include <cmath>

namespace sr::scene {

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
