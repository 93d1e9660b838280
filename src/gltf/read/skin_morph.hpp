#pragma once
// A mesh whose shape moves: first its morph targets displace the vertices, then its skin carries them
// (glTF 2.0 specification, sections 3.7.2.2 and 3.7.3.3).
#include "gltf/read/mesh.hpp"
#include "gltf/read/nodes.hpp"
#include "gltf/warnings.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

namespace sr::gltf {

/// The vertices that one target moves, and by how much. `normals` and `tangents` are empty where it does not
/// turn those, else as many as `vertices`.
struct MorphTarget {
    std::vector<std::uint32_t> vertices; // of the mesh
    std::vector<vec3> positions;
    std::vector<vec3> normals;
    std::vector<vec3> tangents;
};

/// The targets of a primitive, for the vertices that `sources` names.
/// @throws Error if a target has another number of vertices than the primitive, or is not finite
std::vector<MorphTarget> parse_targets(const Document& document, const PrimitivePlace& place,
                                       std::span<const std::uint32_t> sources);

struct Skin {
    std::vector<int> joints;                      // nodes
    std::vector<glm::dmat4> joint_from_mesh_rest; // inverse bind matrices, one a joint
};

/// @throws Error if it has fewer inverse bind matrices than joints, or what is none
Skin parse_skin(const Document& document, int skin);

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
Influences parse_influences(const Document& document, const PrimitivePlace& place,
                            std::span<const std::uint32_t> sources, Warnings& warnings);

/// All that moves the vertices of a primitive, told for the vertices of the mesh that was made of it.
struct Deformation {
    std::vector<vec3> positions; // at rest
    std::vector<vec3> normals;
    std::vector<vec4> tangents;
    std::vector<MorphTarget> targets;
    Influences influences; // perhaps none
    /// The file has no normals: the triangles are flat, however they turn.
    bool has_flat_normals = false;
    /// The file has no tangents: they are computed along this set of texture coordinates.
    std::optional<int> tangents_along;
};

/// @param mesh what build_mesh() made of the primitive
Deformation build_deformation(const Document& document, const PrimitivePlace& place, const SourcedMesh& mesh,
                              const scene::Material& material, Warnings& warnings);

/// Moves the vertices of `mesh`, which is the one that the deformation was told for, or a copy of it.
/// @param weights of the targets; absent ones are 0
/// @param joints world_from_rest() of the skin; empty: no skin. With a skin the mesh ends up in the world.
void deform(const Deformation& deformation, std::span<const double> weights,
            std::span<const glm::dmat4> joints, scene::Mesh& mesh);

} // namespace sr::gltf
