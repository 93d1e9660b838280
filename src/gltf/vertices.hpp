#pragma once
// Reordering, copying and dropping the vertices of a mesh.
#include "scene/scene.hpp"

#include <cstdint>
#include <span>

namespace sr::gltf {

/// Makes vertex `sources[i]` of every array the new vertex i; the indices are the caller's to renumber.
void gather(scene::Mesh& mesh, std::span<const std::uint32_t> sources);

/// Gives each triangle three vertices of its own.
void unweld(scene::Mesh& mesh);

/// Drops the vertices that no triangle uses: exporters share one vertex array among many primitives.
void drop_unused(scene::Mesh& mesh);

} // namespace sr::gltf
