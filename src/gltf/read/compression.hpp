#pragma once
// Compressed meshes, unpacked as soon as a file is read, so that all later code sees plain
// buffers. Each extension is read where its library was found at build time; else a file that needs it is
// refused.
#include "gltf/document.hpp"

namespace sr::gltf {

/// Returns whether this build reads EXT_meshopt_compression and KHR_meshopt_compression.
bool reads_meshopt();

/// Unpacks the buffer views that these extensions pack: they come to lie in buffers of their own.
/// @throws Error naming a view whose data is broken, cut short, or states a size that it cannot hold
void unpack_meshopt(Document& document);

/// Returns whether this build reads KHR_draco_mesh_compression.
bool reads_draco();

/// Unpacks the primitives that KHR_draco_mesh_compression packs: they get accessors of their own.
/// @throws Error naming a primitive whose data is broken, cut short, or not what its accessors announce
void unpack_draco(Document& document);

} // namespace sr::gltf
