#pragma once
// Tangents compatible with MikkTSpace, the frame that normal maps are baked in.
#include "core/math.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace sr::gltf {

/// A tangent for every triangle corner (three an index triple): xyz is unit and perpendicular to the normal,
/// bitangent = w * cross(normal, xyz). All vertex arrays have the same length.
///
/// The bitangent points where the texture's picture goes up (against glTF's v, which goes down), because
/// glTF's normal maps have +Y up: w is the opposite of what MikkTSpace gives for the same numbers.
///
/// Corners that no texture direction can be given for (no area in space or texture) get (1, 0, 0, 1).
std::vector<vec4> mikktspace(std::span<const vec3> positions, std::span<const vec3> normals,
                             std::span<const vec2> texcoords, std::span<const std::uint32_t> indices);

} // namespace sr::gltf
