#pragma once
// Morph targets: how far each vertex goes where (glTF 2.0 specification, section 3.7.2.2).
#include "gltf/mesh.hpp"

#include <cstdint>
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
std::vector<MorphTarget> targets_of(const Document& document, const PrimitivePlace& place,
                                    std::span<const std::uint32_t> sources);

} // namespace sr::gltf
