#pragma once
// A mesh whose shape moves: first its morph targets displace the vertices, then its skin carries them
// (glTF 2.0 specification, sections 3.7.2.2 and 3.7.3.3).
#include "gltf/morph.hpp"
#include "gltf/skin.hpp"

#include <optional>

namespace sr::gltf {

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

/// @param mesh what mesh_of() made of the primitive
Deformation deformation_of(const Document& document, const PrimitivePlace& place, const SourcedMesh& mesh,
                           const scene::Material& material, Warnings& warnings);

/// Moves the vertices of `mesh`, which is the one that the deformation was told for, or a copy of it.
/// @param weights of the targets; absent ones are 0
/// @param joints world_from_rest() of the skin; empty: no skin. With a skin the mesh ends up in the world.
void deform(const Deformation& deformation, std::span<const double> weights,
            std::span<const glm::dmat4> joints, scene::Mesh& mesh);

} // namespace sr::gltf
