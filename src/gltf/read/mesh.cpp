#include "gltf/read/mesh.hpp"

#include "gltf/read/accessor.hpp"
#include "gltf/read/vertices.hpp"
#include "gltf/tinygltf.hpp"
#include "gltf/warnings.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <fmt/format.h>
#include <numeric>
#include <string_view>
#include <utility>

namespace sr::gltf {
namespace {

constexpr int points_mode = 0;
constexpr int line_list_mode = 1;
constexpr int line_loop_mode = 2;
constexpr int list_mode = 4;
constexpr int strip_mode = 5;

} // namespace

bool is_surface(int mode) { return mode >= list_mode; }

bool is_points(int mode) { return mode == points_mode; }

std::vector<std::uint32_t> triangles(std::vector<std::uint32_t> indices, int mode) {
    if (mode == list_mode) {
        indices.resize(indices.size() / 3 * 3);
        return indices;
    }
    std::vector<std::uint32_t> result;
    if (indices.size() < 3) return result;
    result.reserve((indices.size() - 2) * 3);
    for (std::size_t i = 0; i + 2 < indices.size(); ++i) {
        // Specification: strip p_i = {v_i, v_(i+1+i%2), v_(i+2-i%2)}, fan p_i = {v_(i+1), v_(i+2), v_0}.
        const std::size_t odd = i % 2;
        if (mode == strip_mode)
            result.insert(result.end(), {indices[i], indices[i + 1 + odd], indices[i + 2 - odd]});
        else
            result.insert(result.end(), {indices[i + 1], indices[i + 2], indices[0]});
    }
    return result;
}

std::vector<std::uint32_t> lines(std::vector<std::uint32_t> indices, int mode) {
    if (mode == line_list_mode) {
        indices.resize(indices.size() / 2 * 2);
        return indices;
    }
    std::vector<std::uint32_t> result;
    if (indices.size() < 2) return result;
    result.reserve(2 * indices.size());
    for (std::size_t i = 0; i + 1 < indices.size(); ++i)
        result.insert(result.end(), {indices[i], indices[i + 1]});
    if (mode == line_loop_mode) result.insert(result.end(), {indices.back(), indices.front()});
    return result;
}

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

/// `corners`: of each triangle, line or point.
void drop_infinite(scene::Mesh& mesh, std::size_t corners, Warnings& warnings) {
    if (std::all_of(mesh.positions.begin(), mesh.positions.end(), is_finite)) return;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += corners) {
        const auto first = mesh.indices.begin() + static_cast<std::ptrdiff_t>(i);
        const auto end = first + static_cast<std::ptrdiff_t>(corners);
        if (!std::all_of(first, end, [&](std::uint32_t v) { return is_finite(mesh.positions[v]); })) continue;
        std::copy(first, end, mesh.indices.begin() + static_cast<std::ptrdiff_t>(kept));
        kept += corners;
    }
    constexpr std::array<std::string_view, 3> names{"point", "line", "triangle"};
    warnings.add(fmt::format("a {} has a position that is not finite", names[corners - 1]), "it is left out",
                 (mesh.indices.size() - kept) / corners);
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
    std::size_t clamped = 0; // the specification, section 3.7.2.1: within 0 and 1
    for (vec4& color : mesh.colors) {
        if (!is_finite(vec3(color)) || !std::isfinite(color.w))
            document.fail(fmt::format("{}/attributes/COLOR_0 is not finite", place.pointer()),
                          "export the file again");
        const vec4 inside = glm::clamp(color, 0.0f, 1.0f);
        if (inside != color) ++clamped, color = inside;
    }
    warnings.add("a vertex colour is outside 0 to 1", "it is clamped", clamped);
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

/// Leaves in `mesh` the points or lines of mode `mode`, whose corners are its indices. Without normals they
/// are unlit, and without the file's own tangents they have no normal map (glTF 2.0, section 3.9.7).
void finish_lines(SourcedMesh& mesh, int mode, Warnings& warnings) {
    (is_points(mode) ? mesh.points : mesh.lines) = std::exchange(mesh.indices, {});
    warnings.add("a normal of a point or line is zero or not finite",
                 "the point or line faces the viewer there", repair_normals(mesh));
    warnings.add("a tangent is zero, not finite or along its normal", "it is replaced by one across",
                 repair_tangents(mesh));
}

void warn_of_absent_texcoords(const scene::Mesh& mesh, const scene::Material& material, Warnings& warnings) {
    for (const scene::TextureInput& input : scene::texture_inputs)
        if (const scene::TextureSlot& slot = material.*input.member;
            slot.is_present() && mesh.texcoords[slot.texcoord].empty())
            warnings.add(fmt::format("mesh {} has a texture and no TEXCOORD_{}", in_quotes(mesh.name),
                                     material.texcoord_sets[static_cast<std::size_t>(slot.texcoord)]),
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

std::optional<SourcedMesh> build_mesh(const Document& document, const PrimitivePlace& place,
                                      const scene::Material& material, Warnings& warnings) {
    const tinygltf::Mesh& source = document.model->meshes[static_cast<std::size_t>(place.mesh)];
    const tinygltf::Primitive& primitive = source.primitives[static_cast<std::size_t>(place.primitive)];
    const auto position = primitive.attributes.find("POSITION");
    if (position == primitive.attributes.end()) {
        warnings.add("a primitive has no positions", "it is left out");
        return std::nullopt;
    }
    SourcedMesh mesh;
    mesh.name = source.name;
    mesh.positions = vectors<3>(document, position->second);
    mesh.sources.resize(mesh.positions.size());
    std::iota(mesh.sources.begin(), mesh.sources.end(), 0u);
    const bool is_triangles = is_surface(primitive.mode);
    mesh.indices = corners(document, primitive, mesh.positions.size(), place);
    if (is_triangles)
        mesh.indices = triangles(std::move(mesh.indices), primitive.mode);
    else if (!is_points(primitive.mode))
        mesh.indices = lines(std::move(mesh.indices), primitive.mode);
    read_frame(document, primitive, place, scene::needs_tangents(material), mesh);
    read_surface(document, primitive, place, material, mesh, warnings);
    drop_infinite(mesh, is_triangles ? 3 : is_points(primitive.mode) ? 1 : 2, warnings);
    drop_unused(mesh);
    if (is_triangles)
        finish_frame(mesh, material, warnings);
    else
        finish_lines(mesh, primitive.mode, warnings);
    warn_of_absent_texcoords(mesh, material, warnings);
    return mesh;
}

} // namespace sr::gltf
