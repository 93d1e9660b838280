#include "gltf/polygon.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace sr::gltf {
namespace {

using glm::dvec3;

/// What is wrong with the polygon; empty if nothing is.
std::string fault_of(const std::vector<dvec3>& corners) {
    const std::size_t count = corners.size();
    if (count < 3) return "has fewer than three corners";
    dvec3 normal(0.0); // Newell's: twice the area long
    double extent = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        const dvec3 edge = corners[(i + 1) % count] - corners[i];
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
        const dvec3 before = glm::normalize(corners[i] - corners[(i + count - 1) % count]);
        const dvec3 after = glm::normalize(corners[(i + 1) % count] - corners[i]);
        const double sine = glm::dot(glm::cross(before, after), normal);
        if (sine < -slack) return fmt::format("is not convex at corner {}", i);
        turn += std::atan2(sine, glm::dot(before, after));
    }
    return turn > 3.0 * glm::pi<double>() ? "crosses itself" : "";
}

} // namespace

std::vector<vec3> polygon_corners(const Document& document, const tinygltf::Value& list,
                                  const glm::dmat4& world_from_node, const std::string& title) {
    std::vector<dvec3> corners;
    for (int i = 0; i < static_cast<int>(list.ArrayLen()); ++i) {
        const tinygltf::Value& point = list.Get(i);
        const glm::dvec4 local(point.Get(0).GetNumberAsDouble(), point.Get(1).GetNumberAsDouble(),
                               point.Get(2).GetNumberAsDouble(), 1.0);
        corners.emplace_back(world_from_node * local);
    }
    if (glm::determinant(glm::dmat3(world_from_node)) < 0.0) std::reverse(corners.begin(), corners.end());
    const std::string fault = fault_of(corners);
    if (!fault.empty())
        document.fail(fmt::format("{} {}", title, fault),
                      "give three or more corners around a flat convex polygon");
    std::vector<vec3> result;
    for (const dvec3 corner : corners) {
        result.emplace_back(corner);
        if (!std::isfinite(glm::dot(result.back(), result.back())))
            document.fail(fmt::format("{} stands beyond the range of 32-bit floats", title), "scale it down");
    }
    return result;
}

} // namespace sr::gltf
