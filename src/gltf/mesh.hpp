#pragma once
// One glTF primitive → one scene::Mesh.
#include "gltf/document.hpp"
#include "gltf/vertices.hpp"
#include "gltf/warnings.hpp"
#include "scene/scene.hpp"

#include <map>
#include <optional>
#include <string>

namespace sr::gltf {

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
std::optional<SourcedMesh> mesh_of(const Document& document, const PrimitivePlace& place,
                                   const scene::Material& material, Warnings& warnings);

/// The accessor of an attribute, checked to have an element for every vertex; absent where the attribute is.
/// @throws Error if it has another number of elements
std::optional<int> attribute(const Document& document, const std::map<std::string, int>& attributes,
                             const char* name, std::size_t vertex_count, const PrimitivePlace& place);

} // namespace sr::gltf
