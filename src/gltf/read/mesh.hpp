#pragma once
// One glTF primitive → one scene::Mesh.
#include "gltf/document.hpp"
#include "gltf/read/vertices.hpp"
#include "gltf/warnings.hpp"
#include "scene/scene.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
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

/// The place of a primitive in the file: /meshes/M/primitives/P.
struct PrimitivePlace {
    int mesh = 0;
    int primitive = 0;

    std::string pointer() const;
};

/// The primitive as triangles with normals, and tangents where its material has a normal map; or as points or
/// lines, with what the file has of these. Absent where it has no positions. `Mesh::material` is the
/// caller's.
/// @throws Error if an index or an attribute's length contradicts the positions
std::optional<SourcedMesh> build_mesh(const Document& document, const PrimitivePlace& place,
                                      const scene::Material& material, Warnings& warnings);

/// The accessor of an attribute, checked to have an element for every vertex; absent where the attribute is.
/// @throws Error if it has another number of elements
std::optional<int> attribute(const Document& document, const std::map<std::string, int>& attributes,
                             const char* name, std::size_t vertex_count, const PrimitivePlace& place);

} // namespace sr::gltf
