#pragma once
// Tangents for meshes with a normal map.
#include "gltf/vertices.hpp"

namespace sr::gltf {

/// Computes MikkTSpace tangents along the texture coordinate set and splits vertices whose triangles
/// disagree. A mesh without that set gets tangents that are perpendicular to its normals and otherwise
/// arbitrary.
void add_tangents(SourcedMesh& mesh, int texcoord_set);

/// Computes them again for vertices that moved; none is split, since texture coordinates do not move.
void renew_tangents(scene::Mesh& mesh, int texcoord_set);

/// Makes the file's tangents unit and w = ±1. One that is zero, not finite or along the normal is replaced by
/// any perpendicular one. @return how many were replaced
std::size_t repair_tangents(scene::Mesh& mesh);

} // namespace sr::gltf
