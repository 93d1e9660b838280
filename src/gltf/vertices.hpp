#pragma once
// Reordering, copying and dropping the vertices of a mesh.
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

} // namespace sr::gltf
