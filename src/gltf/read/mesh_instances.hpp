#pragma once
// Mesh instances of a scene's nodes: the meshes, their materials and places, and their shape at a time.
#include "gltf/document.hpp"
#include "gltf/read/material.hpp"
#include "gltf/read/skin_morph.hpp"

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sr::gltf {

std::vector<std::string> variant_names(const Document& document);

/// The number of the variant with this name; absent for an empty name. @throws Error naming those there are
std::optional<int> find_variant(const Document& document, std::string_view name);

class MeshInstances {
public:
    /// @param nodes of the scene, as tree.flatten() returns them
    /// @param variant as find_variant() returns it. The document must outlive this.
    MeshInstances(const Document& document, const NodeTree& tree, const std::vector<NodeTransform>& nodes,
                  std::optional<int> variant);

    /// Requests every material that a primitive of the scene has, always in the same order.
    void request_materials(MaterialTable& materials) const;

    /// Appends the meshes to a scene that has its materials. A mesh that keeps its shape is appended once for
    /// all nodes, one that deforms once for each node.
    /// @throws Error as build_mesh(), parse_skin(), build_deformation() do
    void build(MaterialTable& materials, scene::Scene& scene, Warnings& warnings);

    /// Replaces the scene's instances, and moves the vertices of the meshes that deform.
    /// @param nodes the same nodes at the time, relative to the scene's origin
    /// @return for each instance whether it is visible
    std::vector<bool> evaluate(const std::vector<NodeTransform>& nodes, scene::Scene& scene) const;

private:
    /// A primitive as a mesh at rest, and what moves it, if anything can.
    struct Primitive {
        int mesh = -1;          // in the scene, for nodes that do not deform it; negative: not there
        glm::dvec3 middle{0.0}; // of a mesh whose vertices lie far out: the origin of its positions
        std::shared_ptr<const scene::Mesh> rest;
        std::shared_ptr<const Deformation> deformation;
    };
    /// A mesh of the scene that a node draws.
    struct InstancedMesh {
        std::size_t node = 0; // in nodes_
        int mesh = 0;
        int skin = -1;
        std::shared_ptr<const Deformation> deformation; // null: it keeps its shape
        std::vector<glm::dmat4> node_from_instance;
    };

    std::vector<Primitive> build_primitives(int mesh, MaterialTable& materials, scene::Scene& scene,
                                            Warnings& warnings);
    void add(std::size_t node, Primitive& primitive, scene::Scene& scene, Warnings& warnings);
    /// @throws Error if this is more than a file may draw
    void count(const InstancedMesh& instanced, const NodeTransform& node, const scene::Mesh& mesh);
    void require_joints(int skin, const Deformation& deformation) const;
    /// world_from_rest() of every skin that is drawn. Joints outside the scene, which glTF forbids and real
    /// files have, stand where they would in a scene of their own.
    std::map<int, std::vector<glm::dmat4>> joints(const std::vector<NodeTransform>& nodes,
                                                  glm::dvec3 origin) const;
    void append_instances(const InstancedMesh& instanced, const NodeTransform& node,
                          scene::Scene& scene) const;

    const Document& document_;
    const NodeTree& tree_;
    std::vector<NodeTransform> nodes_; // at rest
    std::vector<int> meshes_;          // of the file, in the order in which nodes name them
    std::optional<int> variant_;
    std::map<int, Skin> skins_;
    std::vector<InstancedMesh> instanced_;
    Tally made_count_; // vertices of meshes, each counted before it is made
    Tally instance_count_, vertex_count_, name_size_;
};

} // namespace sr::gltf
