#pragma once
// EXT_mesh_gpu_instancing: a node that draws its mesh many times.
#include "gltf/hierarchy.hpp"

#include <vector>

namespace sr::gltf {

/// Where the node draws its mesh, in its own space; a single identity where it does not use the extension.
/// @throws Error if the attributes are not as many as each other, or not finite
std::vector<glm::dmat4> instances_of(const Document& document, int node);

} // namespace sr::gltf
