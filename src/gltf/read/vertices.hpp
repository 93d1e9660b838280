#pragma once
// The vertices of a mesh: their order, their normals and their tangents.
#include "scene/scene.hpp"

#include <cstdint>
#include <span>

namespace sr::gltf {

/// A mesh whose vertices remember which vertex of the glTF primitive each of them was: what moves vertices is
/// told in those.
struct SourcedMesh : scene::Mesh {
    std::vector<std::uint32_t> sources; // as many as positions
};

/// Makes vertex `sources[i]` of every array the new vertex i; the indices are the caller's to renumber.
void gather(SourcedMesh& mesh, std::span<const std::uint32_t> sources);

/// Gives each triangle three vertices of its own.
void unweld(SourcedMesh& mesh);

/// Drops the vertices that no index names: exporters share one vertex array among many primitives.
void drop_unused(SourcedMesh& mesh);

/// Gives each triangle its own vertices with its face normal, as glTF 2.0 asks for where normals are absent
/// (specification, section 3.7.2.1). A triangle without area gets +Z: it draws nothing.
void add_flat_normals(SourcedMesh& mesh);

/// Gives each vertex the normal of the triangle that it belongs to alone: add_flat_normals after the vertices
/// moved.
void flatten_normals(scene::Mesh& mesh);

/// Normalises the normals. One that is zero or not finite becomes the mean of its faces' normals weighted by
/// area.
/// @return how many were replaced
std::size_t repair_normals(scene::Mesh& mesh);

/// Computes MikkTSpace tangents along the texture coordinate set and splits vertices whose triangles
/// disagree. A mesh without that set gets tangents that are perpendicular to its normals and otherwise
/// arbitrary.
void add_tangents(SourcedMesh& mesh, int texcoord_set);

/// Computes them again for vertices that moved; none is split_container, since texture coordinates do not
/// move.
void renew_tangents(scene::Mesh& mesh, int texcoord_set);

/// Makes the file's tangents unit and w = ±1. One that is zero, not finite or along the normal is replaced by
/// any perpendicular one. @return how many were replaced
std::size_t repair_tangents(scene::Mesh& mesh);

} // namespace sr::gltf
