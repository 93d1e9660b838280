#pragma once
// Skins: which joints move a mesh, and how far each vertex follows each (glTF 2.0 specification, section
// 3.7.3.3).
#include "gltf/hierarchy.hpp"
#include "gltf/mesh.hpp"
#include "gltf/warnings.hpp"

#include <cstdint>
#include <map>
#include <span>
#include <vector>

namespace sr::gltf {

struct Skin {
    std::vector<int> joints;                      // nodes
    std::vector<glm::dmat4> joint_from_mesh_rest; // inverse bind matrices, one a joint
};

/// @throws Error if it has fewer inverse bind matrices than joints, or what is none
Skin skin_of(const Document& document, int skin);

/// Returns the transform of a vertex from the mesh at rest into the world, for each joint. The node that
/// carries the mesh takes no part.
/// @param world_from_node of each joint
std::vector<glm::dmat4> world_from_rest(const Skin& from, const std::map<int, glm::dmat4>& world_from_node);

/// The joints that a vertex follows, `per_vertex` for each: joint numbers in the skin, and weights that add
/// up to 1.
struct Influences {
    std::size_t per_vertex = 0;
    std::vector<std::uint32_t> joints;
    std::vector<float> weights;

    /// The largest joint number with a weight.
    std::uint32_t last_joint() const;
};

/// Reads JOINTS_n and WEIGHTS_n, for the vertices of the primitive that `sources` names; without a vertex
/// if it has neither. @throws Error if there is one without the other, or a weight is negative or not finite
Influences influences_of(const Document& document, const PrimitivePlace& place,
                         std::span<const std::uint32_t> sources, Warnings& warnings);

} // namespace sr::gltf
