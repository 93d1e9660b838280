#pragma once
// Transforms of directions: what becomes of normals and tangents, and of the front of a triangle.
#include "core/math.hpp"

namespace sr::scene {

/// Returns whether the transform turns triangles inside out: its determinant is negative. A transform that
/// flattens space, as far as floats can tell (its columns span less than a millionth of the box that their
/// lengths make), does not.
bool mirrors(const mat4& transform);

/// Takes a normal to the direction of the transformed normal: the inverse transpose but for a positive
/// factor. Built from cofactors, so that it is finite for every finite transform. Its largest element is 1 in
/// magnitude, unless all are 0, which is the case where the transform leaves no surface an area. A transform
/// that flattens space takes normals to those of the flattened triangles.
mat3 normal_transform(const mat4& transform);

/// v at length 1, whatever its finite length is; `otherwise` where v is zero or not finite.
vec3 unit_or(const glm::dvec3& v, vec3 otherwise);

/// Returns the factor of lengths: the cube root of |det|, which is the scale if it is uniform.
float length_scale(const mat4& transform);

} // namespace sr::scene
