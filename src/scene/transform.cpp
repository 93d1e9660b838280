#include "scene/transform.hpp"

#include <algorithm>
#include <cmath>

namespace sr::scene {
namespace {

using glm::dmat3;
using glm::dvec3;

double max_component(const dvec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

// In double: the product of three floats stays within its range.
dmat3 linear_part(const mat4& transform) { return dmat3(glm::dmat4(transform)); }

} // namespace

bool mirrors(const mat4& transform) {
    constexpr double flat =
        1e-6; // ten times what rounding makes of the determinant of a flattening transform
    const dmat3 m = linear_part(transform);
    return glm::determinant(m) < -flat * glm::length(m[0]) * glm::length(m[1]) * glm::length(m[2]);
}

mat3 normal_transform(const mat4& transform) {
    const dmat3 m = linear_part(transform);
    const double side = mirrors(transform) ? -1.0 : 1.0;
    dmat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
    const double largest =
        std::max({max_component(cofactors[0]), max_component(cofactors[1]), max_component(cofactors[2])});
    if (largest > 0.0) cofactors *= side / largest;
    return mat3(cofactors);
}

vec3 unit_or(const dvec3& v, vec3 otherwise) {
    const double length = glm::length(v);
    return length > 0.0 && std::isfinite(length) ? vec3(v / length) : otherwise;
}

float length_scale(const mat4& transform) {
    return static_cast<float>(std::cbrt(std::abs(glm::determinant(linear_part(transform)))));
}

} // namespace sr::scene
