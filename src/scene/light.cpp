#include "scene/light.hpp"

#include <algorithm>
#include <cmath>

namespace sr::scene {
namespace {

/// Twice the vector area: twice the area long, along the normal.
vec3 doubled_vector_area(const std::vector<vec3>& corners) {
    vec3 sum(0.0f);
    for (std::size_t i = 2; i < corners.size(); ++i)
        sum += glm::cross(corners[i - 1] - corners[0], corners[i] - corners[0]);
    return sum;
}

} // namespace

ConeFalloff cone_falloff(const SpotLight& light) {
    constexpr double narrowest = 1e-6; // that 32-bit cosines can tell apart
    const double cos_outer = std::cos(double{light.outer_angle});
    const double scale = 1.0 / std::max(narrowest, std::cos(double{light.inner_angle}) - cos_outer);
    return {static_cast<float>(scale), static_cast<float>(-cos_outer * scale)};
}

float PolygonLight::area() const { return 0.5f * glm::length(doubled_vector_area(corners)); }

vec3 PolygonLight::normal() const { return glm::normalize(doubled_vector_area(corners)); }

vec3 PolygonLight::center() const {
    vec3 sum(0.0f);
    for (const vec3 corner : corners) sum += corner;
    return sum / static_cast<float>(corners.size());
}

float MeshLight::area() const {
    float doubled = 0.0f;
    for (const auto& [corners, uv] : triangles)
        doubled += glm::length(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
    return 0.5f * doubled;
}

bool passes_back_faces(const Light& light) {
    return std::visit(
        [](const auto& any) {
            if constexpr (requires { any.passes_back_faces; })
                return any.passes_back_faces;
            else
                return false;
        },
        light);
}

} // namespace sr::scene
