#pragma once
// Mesh instances of a scene's nodes: the meshes, their places, and their shape at a time.
#include "gltf/deformation.hpp"
#include "gltf/material.hpp"

#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace sr::gltf {

class DrawnMeshes {
public:
    /// `placed` as placed_nodes() gives it. The document must outlive this.
    DrawnMeshes(const Document& document, const std::vector<PlacedNode>& placed, std::optional<int> variant);

    /// Asks for every material that a primitive of the scene has, always in the same order.
    void ask_for(MaterialTable& materials) const;

    /// Appends the meshes to a scene whose materials are there. A mesh that keeps its shape is there once for
    /// all nodes, one that deforms once a node. @param materials has been read
    /// @throws Error as mesh_of(), skin_of(), deformation_of() do
    void read(MaterialTable& materials, scene::Scene& scene, Warnings& warnings);

    /// Replaces the scene's instances, told from its origin, and moves the vertices of the meshes that
    /// deform.
    /// @param placed the same nodes at the moment
    /// @return for each instance whether it is visible
    std::vector<bool> pose(const std::vector<PlacedNode>& placed, scene::Scene& scene) const;

private:
    /// A primitive as a mesh at rest, and what moves it, if anything can.
    struct Part {
        int mesh = -1;          // in the scene, for nodes that do not deform it; negative: not there
        glm::dvec3 middle{0.0}; // of a mesh whose vertices lie far out: the origin of its positions
        std::shared_ptr<const scene::Mesh> rest;
        std::shared_ptr<const Deformation> deformation;
    };
    /// A mesh of the scene that a node draws.
    struct Drawn {
        std::size_t placed = 0;
        int mesh = 0;
        int skin = -1;
        std::shared_ptr<const Deformation> deformation; // null: it keeps its shape
        std::vector<glm::dmat4> node_from_instance;
    };

    std::vector<Part> parts_of(int mesh, MaterialTable& materials, scene::Scene& scene, Warnings& warnings);
    void add(std::size_t placed, const PlacedNode& node, Part& part, scene::Scene& scene, Warnings& warnings);
    /// @throws Error if this is more than a file may draw
    void count(const Drawn& drawn, const PlacedNode& node, const scene::Mesh& mesh);
    void require_joints(int skin, const Deformation& deformation) const;
    /// world_from_rest() of every skin that is drawn. Joints outside the scene, which glTF forbids and real
    /// files have, stand where they would in a scene of their own.
    std::map<int, std::vector<glm::dmat4>> joints(const std::vector<PlacedNode>& placed,
                                                  glm::dvec3 origin) const;
    void append_instances(const Drawn& drawn, const PlacedNode& node, scene::Scene& scene) const;

    const Document& document_;
    std::vector<PlacedNode> placed_; // those with meshes count
    std::vector<int> meshes_;        // of the file, in the order in which nodes name them
    std::optional<int> variant_;
    std::map<int, Skin> skins_;
    std::vector<Drawn> drawn_;
    Tally made_count_; // vertices of meshes, each counted before it is made
    Tally instance_count_, vertex_count_, name_size_;
};

} // namespace sr::gltf
