#pragma once
// Irradiance in closed form or by a contour in doubles: what emitters of radiance 1 give on the plane y = 0,
// facing up.
#include "scene/lights/light.hpp"

#include <glm/vec3.hpp>
#include <vector>

namespace sr::testing {

/// E/L at x of the part above the horizon of a flat convex outline, whose front x is on: clipped in doubles,
/// then E = 1/2 Σ θ_k (Γ_k · n), with θ_k the angle that edge k subtends and Γ_k the unit normal of its plane
/// through x (Lambert 1760; in this form Baum et al. 1989, Eq. 5).
double polygon_irradiance(const std::vector<glm::dvec3>& corners, glm::dvec3 x);

/// The outline of an ellipse by 4096 corners, within 1e-6 of its area.
double disk_irradiance(const scene::DiskLight& light, glm::dvec3 x);

/// E/L = π (r/d)² cosθ where the ball is wholly above the horizon; else by the disk that it looks like.
double sphere_irradiance(const scene::SphereLight& light, glm::dvec3 x);

std::vector<glm::dvec3> corners_of(const scene::RectangleLight& light);
std::vector<glm::dvec3> corners_of(const scene::PolygonLight& light);

} // namespace sr::testing
