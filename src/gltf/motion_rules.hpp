#pragma once
// The rules of what moves, repeats, exchanges or packs parts of a file: skins, animations, and extensions of
// nodes and primitives.
#include "gltf/schema.hpp"

namespace sr::gltf {

const Rule& skin_rule();
const Rule& animation_rule();
const Rule& visibility_rule();           // KHR_node_visibility in a node
const Rule& instancing_rule();           // EXT_mesh_gpu_instancing in a node
const Rule& variants_rule();             // KHR_materials_variants in the root
const Rule& view_extensions_rule();      // EXT_meshopt_compression
const Rule& primitive_extensions_rule(); // KHR_materials_variants, KHR_draco_mesh_compression

} // namespace sr::gltf
