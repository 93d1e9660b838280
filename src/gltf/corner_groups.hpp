#pragma once
// Groups of triangle corners around a vertex that share one tangent: the topological half of MikkTSpace
// (mikktspace.cpp).
#include "core/math.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace sr::gltf {

/// How a triangle lies in the texture. `any`: without area there, so it joins either kind; `degenerate`:
/// without area in space, so it joins none.
enum class TriangleTurn : std::uint8_t { preserving, mirroring, any, degenerate };

/// Corners (positions in the index array) of one vertex that are connected by edges and turn the same way.
struct CornerGroup {
    std::vector<std::uint32_t> corners;
    TriangleTurn turn = TriangleTurn::preserving;
};

/// For each corner the first corner whose vertex is equal in position, normal and texture coordinate.
std::vector<std::uint32_t> weld(std::span<const vec3> positions, std::span<const vec3> normals,
                                std::span<const vec2> texcoords, std::span<const std::uint32_t> indices);

/// The groups of all corners. A triangle that turns `any` way takes the turn of the first group that reaches
/// it.
/// @param welded one entry a corner, as weld() gives it
std::vector<CornerGroup> corner_groups(std::span<const std::uint32_t> welded,
                                       std::span<const TriangleTurn> turns);

} // namespace sr::gltf
