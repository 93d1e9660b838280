#include "gltf/mesh.hpp"

#include "gltf/accessor.hpp"
#include "gltf/normals.hpp"
#include "gltf/tangents.hpp"
#include "gltf/text.hpp"
#include "gltf/topology.hpp"
#include "gltf/vertices.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numeric>

namespace sr::gltf {
namespace {

std::vector<std::uint32_t> corners(const Document& document, const tinygltf::Primitive& primitive,
                                   std::size_t vertex_count, const PrimitivePlace& place) {
    if (primitive.indices < 0) {
        std::vector<std::uint32_t> all(vertex_count);
        std::iota(all.begin(), all.end(), 0u);
        return all;
    }
    std::vector<std::uint32_t> result = indices(document, primitive.indices);
    const std::uint32_t restart = restart_index(document, primitive.indices);
    for (const std::uint32_t index : result) {
        if (index < vertex_count && index != restart) continue;
        if (index == restart)
            document.fail(
                fmt::format("{}/indices contains the primitive restart value {}, which glTF forbids",
                            place.pointer(), index),
                "export each strip as a primitive of its own");
        document.fail(fmt::format("{}/indices contains {}, and there are {} vertices", place.pointer(), index,
                                  vertex_count),
                      "export the file again");
    }
    return result;
}

bool is_finite(vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

void drop_infinite_triangles(scene::Mesh& mesh, Warnings& warnings) {
    if (std::all_of(mesh.positions.begin(), mesh.positions.end(), is_finite)) return;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const auto first = mesh.indices.begin() + static_cast<std::ptrdiff_t>(i);
        if (!std::all_of(first, first + 3, [&](std::uint32_t v) { return is_finite(mesh.positions[v]); }))
            continue;
        std::copy_n(first, 3, mesh.indices.begin() + static_cast<std::ptrdiff_t>(kept));
        kept += 3;
    }
    warnings.add("a triangle has a position that is not finite", "it is left out",
                 (mesh.indices.size() - kept) / 3);
    mesh.indices.resize(kept);
}

std::vector<vec4> colors(const Document& document, int accessor) {
    if (components_of(document, accessor) == 4) return vectors<4>(document, accessor);
    const std::vector<vec3> opaque = vectors<3>(document, accessor);
    std::vector<vec4> result;
    result.reserve(opaque.size());
    for (const vec3 color : opaque) result.emplace_back(color, 1.0f);
    return result;
}

// Specification, section 3.7.2.1: the file's tangents count only together with its normals.
void read_frame(const Document& document, const tinygltf::Primitive& primitive, const PrimitivePlace& place,
                bool needs_tangents, scene::Mesh& mesh) {
    const auto normal = attribute(document, primitive.attributes, "NORMAL", mesh.positions.size(), place);
    const auto tangent = attribute(document, primitive.attributes, "TANGENT", mesh.positions.size(), place);
    if (normal) mesh.normals = vectors<3>(document, *normal);
    if (normal && tangent && needs_tangents) mesh.tangents = vectors<4>(document, *tangent);
}

void read_surface(const Document& document, const tinygltf::Primitive& primitive, const PrimitivePlace& place,
                  const scene::Material& material, scene::Mesh& mesh, Warnings& warnings) {
    const std::size_t count = mesh.positions.size();
    if (const auto color = attribute(document, primitive.attributes, "COLOR_0", count, place))
        mesh.colors = colors(document, *color);
    for (const vec4 color : mesh.colors)
        if (!is_finite(vec3(color)) || !std::isfinite(color.w))
            document.fail(fmt::format("{}/attributes/COLOR_0 is not finite", place.pointer()),
                          "export the file again");
    for (int set = 0; set < 2; ++set) {
        const std::string name =
            fmt::format("TEXCOORD_{}", material.texcoord_sets[static_cast<std::size_t>(set)]);
        const auto texcoord = attribute(document, primitive.attributes, name.c_str(), count, place);
        if (!texcoord) continue;
        mesh.texcoords[set] = vectors<2>(document, *texcoord);
        std::size_t bad_count = 0;
        for (vec2& uv : mesh.texcoords[set])
            if (!std::isfinite(uv.x) || !std::isfinite(uv.y)) ++bad_count, uv = vec2(0.0f);
        warnings.add("a texture coordinate is not finite", "it is taken for (0, 0)", bad_count);
    }
}

void finish_frame(SourcedMesh& mesh, const scene::Material& material, Warnings& warnings) {
    if (mesh.normals.empty())
        add_flat_normals(mesh);
    else
        warnings.add("a normal is zero or not finite", "it is replaced by that of its faces",
                     repair_normals(mesh));
    if (!scene::needs_tangents(material)) return;
    if (mesh.tangents.empty())
        add_tangents(mesh, scene::tangent_texcoord(material));
    else
        warnings.add("a tangent is zero, not finite or along its normal", "it is replaced by one across",
                     repair_tangents(mesh));
}

void warn_of_absent_texcoords(const scene::Mesh& mesh, const scene::Material& material, Warnings& warnings) {
    for (const scene::TextureSlot* slot : scene::texture_slots(material))
        if (slot->is_present() && mesh.texcoords[slot->texcoord].empty())
            warnings.add(fmt::format("mesh {} has a texture and no TEXCOORD_{}", in_quotes(mesh.name),
                                     material.texcoord_sets[static_cast<std::size_t>(slot->texcoord)]),
                         "its texture is read at (0, 0)");
}

} // namespace

std::string PrimitivePlace::pointer() const {
    return fmt::format("/meshes/{}/primitives/{}", mesh, primitive);
}

std::optional<int> attribute(const Document& document, const std::map<std::string, int>& attributes,
                             const char* name, std::size_t vertex_count, const PrimitivePlace& place) {
    const auto found = attributes.find(name);
    if (found == attributes.end()) return std::nullopt;
    const std::size_t count = count_of(document, found->second);
    if (count != vertex_count)
        document.fail(
            fmt::format("{} has {} of {} and {} of POSITION", place.pointer(), count, name, vertex_count),
            "export the file again");
    return found->second;
}

std::optional<SourcedMesh> mesh_of(const Document& document, const PrimitivePlace& place,
                                   const scene::Material& material, Warnings& warnings) {
    const tinygltf::Mesh& source = document.model.meshes[static_cast<std::size_t>(place.mesh)];
    const tinygltf::Primitive& primitive = source.primitives[static_cast<std::size_t>(place.primitive)];
    const auto position = primitive.attributes.find("POSITION");
    if (!is_surface(primitive.mode)) {
        warnings.add("a primitive is made of points or lines", "only surfaces are drawn, it is left out");
        return std::nullopt;
    }
    if (position == primitive.attributes.end()) {
        warnings.add("a primitive has no positions", "it is left out");
        return std::nullopt;
    }
    SourcedMesh mesh;
    mesh.name = source.name;
    mesh.positions = vectors<3>(document, position->second);
    mesh.sources.resize(mesh.positions.size());
    std::iota(mesh.sources.begin(), mesh.sources.end(), 0u);
    mesh.indices = triangles(corners(document, primitive, mesh.positions.size(), place), primitive.mode);
    read_frame(document, primitive, place, scene::needs_tangents(material), mesh);
    read_surface(document, primitive, place, material, mesh, warnings);
    drop_infinite_triangles(mesh, warnings);
    drop_unused(mesh);
    finish_frame(mesh, material, warnings);
    warn_of_absent_texcoords(mesh, material, warnings);
    return mesh;
}

} // namespace sr::gltf
