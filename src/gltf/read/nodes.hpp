#pragma once
// The node hierarchy of a scene, flattened, and the instances of a node (EXT_mesh_gpu_instancing).
#include "gltf/document.hpp"

#include <glm/mat4x4.hpp>
#include <optional>
#include <vector>

namespace sr::gltf {

/// A node and where it stands.
struct NodeTransform {
    int node = 0;
    glm::dmat4 world_from_node{1.0};
    bool is_visible = true; // KHR_node_visibility: neither it nor a node above it says no
};

/// The nodes of the scene asked for, else of the file's default scene, else of its first, else (a file
/// without scenes) all of them; depth first, parents before children.
/// @throws Error if there is no such scene, a node has two parents or is its own ancestor, or a transform is
/// not finite
std::vector<NodeTransform> flatten_nodes(const Document& document, std::optional<int> scene);

/// Where each node stands, whether or not a scene has it. flatten_nodes() has checked that the nodes are
/// trees.
std::vector<glm::dmat4> world_from_nodes(const Document& document);

/// Where the node draws its mesh, in its own space; a single identity where it does not use the extension.
/// @throws Error if the attributes are not as many as each other, or not finite
std::vector<glm::dmat4> parse_instances(const Document& document, int node);

} // namespace sr::gltf
