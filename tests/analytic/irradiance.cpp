#include "irradiance.hpp"

#include <cmath>
#include <glm/geometric.hpp>

namespace sr::testing {
namespace {

using glm::dvec3;

std::vector<dvec3> above_horizon(const std::vector<dvec3>& corners) {
    std::vector<dvec3> kept;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const dvec3 a = corners[k], b = corners[(k + 1) % corners.size()];
        if (a.y >= 0.0) kept.push_back(a);
        if ((a.y >= 0.0) != (b.y >= 0.0)) kept.push_back(a + a.y / (a.y - b.y) * (b - a));
    }
    return kept;
}

double ellipse_irradiance(dvec3 center, dvec3 u, dvec3 v, dvec3 x) {
    constexpr int count = 4096;
    // Corners stand out a little, so that the polygon has the ellipse's area.
    const double angle = 2.0 * glm::pi<double>() / count;
    const double out = std::sqrt(angle / std::sin(angle));
    std::vector<dvec3> corners;
    for (int i = 0; i < count; ++i)
        corners.push_back(center + out * (std::cos(i * angle) * u + std::sin(i * angle) * v));
    return polygon_irradiance(corners, x);
}

} // namespace

double polygon_irradiance(const std::vector<dvec3>& corners, dvec3 x) {
    std::vector<dvec3> seen;
    for (const dvec3 corner : corners) seen.push_back(corner - x);
    seen = above_horizon(seen);
    double E = 0.0;
    for (std::size_t k = 0; k < seen.size(); ++k) {
        const dvec3 a = glm::normalize(seen[k]), b = glm::normalize(seen[(k + 1) % seen.size()]);
        const dvec3 gamma = glm::cross(a, b);
        const double s = glm::length(gamma);
        if (s > 0.0) E += std::atan2(s, glm::dot(a, b)) * gamma.y / s;
    }
    return 0.5 * std::abs(E);
}

double disk_irradiance(const scene::DiskLight& light, dvec3 x) {
    return ellipse_irradiance(light.center, light.half_u, light.half_v, x);
}

double sphere_irradiance(const scene::SphereLight& light, dvec3 x) {
    const dvec3 c = dvec3(light.center) - x;
    const double d = glm::length(c), r = light.radius;
    if (c.y >= r) return glm::pi<double>() * r * r * c.y / (d * d * d);
    const dvec3 o = c / d;
    const dvec3 u = glm::normalize(glm::cross(o, std::abs(o.x) < 0.5 ? dvec3(1, 0, 0) : dvec3(0, 1, 0)));
    const double tangent = r / std::sqrt(d * d - r * r);
    return ellipse_irradiance(x + o, tangent * u, tangent * glm::cross(o, u), x);
}

std::vector<dvec3> corners_of(const scene::RectangleLight& light) {
    const dvec3 c = light.center, u = light.half_u, v = light.half_v;
    return {c - u - v, c + u - v, c + u + v, c - u + v};
}

std::vector<dvec3> corners_of(const scene::PolygonLight& light) {
    return {light.corners.begin(), light.corners.end()};
}

} // namespace sr::testing
