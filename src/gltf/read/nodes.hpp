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
    const json* source = nullptr; // the node in the document
    glm::dmat4 world_from_node{1.0};
    bool is_visible = true; // KHR_node_visibility: neither it nor a node above it says no
};

/// The hierarchy of a file's nodes. Its shape is read once: animations move nodes, but keep parents and
/// children.
class NodeTree {
public:
    /// @throws Error if a node has two parents or is its own ancestor
    explicit NodeTree(const Document& document);

    /// Returns the nodes of the scene asked for, else of the file's default scene, else of its first, else (a
    /// file without scenes) all of them; depth first, parents before children.
    /// @throws Error if there is no such scene, it names a node twice, or a transform is not finite
    std::vector<NodeTransform> flatten(std::optional<int> scene) const;

    /// Returns where each node stands, whether or not a scene has it.
    std::vector<glm::dmat4> world_from_nodes() const;

private:
    struct Node {
        const json* source = nullptr;
        std::vector<int> children;
        int parent = -1;
    };

    const Node& at(int node) const { return nodes_[static_cast<std::size_t>(node)]; }
    void link();
    void require_no_circle() const;
    std::vector<int> roots(std::optional<int> scene) const;
    NodeTransform below(const NodeTransform& parent, int node) const;

    const Document& document_;
    std::vector<Node> nodes_;
    std::vector<int> orphans_; // nodes without a parent
};

/// Where the node draws its mesh, in its own space; a single identity where it does not use the extension.
/// @throws Error if the attributes are not as many as each other, or not finite
std::vector<glm::dmat4> parse_instances(const Document& document, int node);

} // namespace sr::gltf
