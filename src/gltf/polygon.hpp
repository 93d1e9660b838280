#pragma once
// The corners of a polygonal light.
#include "core/math.hpp"
#include "gltf/document.hpp"

#include <vector>

namespace sr::gltf {

/// A list of [x, y, z] [m] in a node's space, in the world, with the front (from where they go
/// counter-clockwise) kept in front where the node mirrors.
/// @throws Error calling the light `title`, unless they are three or more, in one plane (to 1e-4 of the
/// extent), and go around a convex polygon once
std::vector<vec3> polygon_corners(const Document& document, const tinygltf::Value& list,
                                  const glm::dmat4& world_from_node, const std::string& title);

} // namespace sr::gltf
