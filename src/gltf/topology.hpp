#pragma once
// Primitive modes (glTF 2.0 specification, section 3.7.2.1): strips, fans and loops become lists.
#include <cstdint>
#include <vector>

namespace sr::gltf {

/// Returns whether the mode (0 points … 6 triangle fan) draws surfaces.
bool is_surface(int mode);

/// The triangles of a list (4), strip (5) or fan (6), three indices each, all with the winding of the first.
/// Trailing indices that make no triangle are dropped.
std::vector<std::uint32_t> triangles(std::vector<std::uint32_t> indices, int mode);

/// Returns whether the mode draws points.
bool is_points(int mode);

/// The lines of a list (1), loop (2) or strip (3), two indices each. Trailing indices that make no line are
/// dropped.
std::vector<std::uint32_t> lines(std::vector<std::uint32_t> indices, int mode);

} // namespace sr::gltf
