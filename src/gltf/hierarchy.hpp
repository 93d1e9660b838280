#pragma once
// The node hierarchy of a scene, flattened.
#include "gltf/document.hpp"

#include <glm/mat4x4.hpp>

#include <optional>
#include <vector>

namespace sr::gltf {

/// A node and where it stands.
struct PlacedNode {
    int node = 0;
    glm::dmat4 world_from_node{1.0};
    bool is_visible = true; // KHR_node_visibility: neither it nor a node above it says no
};

/// The nodes of the scene asked for, else of the file's default scene, else of its first, else (a file
/// without scenes) all of them; depth first, parents before children.
/// @throws Error if there is no such scene, a node has two parents or is its own ancestor, or a transform is
/// not finite
std::vector<PlacedNode> placed_nodes(const Document& document, std::optional<int> scene);

/// Where each node stands, whether or not a scene has it. placed_nodes() has checked that the nodes are
/// trees.
std::vector<glm::dmat4> world_from_nodes(const Document& document);

} // namespace sr::gltf
