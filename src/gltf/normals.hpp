#pragma once
// Normals where the file has none, or bad ones.
#include "gltf/vertices.hpp"

namespace sr::gltf {

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

} // namespace sr::gltf
