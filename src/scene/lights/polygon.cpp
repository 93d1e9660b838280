#include "scene/lights/polygon.hpp"

#include "scene/lights/emitter.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace sr::scene {
namespace {

/// Twice the vector area: twice the area long, along the normal.
glm::dvec3 doubled_vector_area(const std::vector<vec3>& corners) {
    glm::dvec3 sum(0.0);
    for (std::size_t i = 2; i < corners.size(); ++i)
        sum += glm::cross(glm::dvec3(corners[i - 1] - corners[0]), glm::dvec3(corners[i] - corners[0]));
    return sum;
}

} // namespace

std::string PolygonLight::fault_of(const std::vector<glm::dvec3>& corners) {
    const std::size_t count = corners.size();
    if (count < 3) return "has fewer than three corners";
    glm::dvec3 normal(0.0); // Newell's: twice the area long
    double extent = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        const glm::dvec3 edge = corners[(i + 1) % count] - corners[i];
        if (!(glm::length(edge) > 0.0)) return fmt::format("has corner {} twice", i);
        normal += glm::cross(corners[i] - corners[0], corners[(i + 1) % count] - corners[0]);
        extent = std::max(extent, glm::length(corners[i] - corners[0]));
    }
    constexpr double slack = 1e-4; // corners typed with four digits are flat
    if (!(glm::length(normal) > 1e-12 * extent * extent)) return "has no area";
    normal = glm::normalize(normal);
    double turn = 0.0; // all exterior angles: one whole turn, or it crosses itself
    for (std::size_t i = 0; i < count; ++i) {
        if (std::abs(glm::dot(corners[i] - corners[0], normal)) > slack * extent)
            return fmt::format("is not flat: corner {} is out of the plane of the others", i);
        const glm::dvec3 before = glm::normalize(corners[i] - corners[(i + count - 1) % count]);
        const glm::dvec3 after = glm::normalize(corners[(i + 1) % count] - corners[i]);
        const double sine = glm::dot(glm::cross(before, after), normal);
        if (sine < -slack) return fmt::format("is not convex at corner {}", i);
        turn += std::atan2(sine, glm::dot(before, after));
    }
    return turn > 3.0 * glm::pi<double>() ? "crosses itself" : "";
}

float PolygonLight::area() const {
    return static_cast<float>(0.5 * glm::length(doubled_vector_area(corners)));
}

vec3 PolygonLight::normal() const { return vec3(glm::normalize(doubled_vector_area(corners))); }

vec3 PolygonLight::center() const {
    vec3 sum(0.0f);
    for (const vec3 corner : corners) sum += corner;
    return sum / static_cast<float>(corners.size());
}

Radiator PolygonLight::radiator() const { return flat_radiator(*this, double{area()}); }

Bounds PolygonLight::bounds() const {
    Bounds box;
    for (const vec3 corner : corners) box.extend(corner);
    return box;
}

void PolygonLight::transform(const Motion& by) {
    for (vec3& corner : corners) corner = by.place(corner);
}

std::optional<LightSurface> PolygonLight::surface() const {
    if (!is_visible) return std::nullopt;
    return LightSurface{fan_mesh(corners, normal()), L, is_two_sided};
}

EmitterPoint PolygonLight::sample_point(vec3 u) const {
    const auto& c = corners;
    vec2 place(u);
    const float whole = area();
    const std::size_t i = part_at(place.x, c.size() - 2, whole, [&](std::size_t part) {
        return triangle_area(c[0], c[part + 1], c[part + 2]);
    });
    const vec2 weights = in_triangle(place);
    return {c[0] + weights.x * (c[i + 1] - c[0]) + weights.y * (c[i + 2] - c[0]), normal(), whole, vec2(0.0f),
            is_two_sided};
}

} // namespace sr::scene
