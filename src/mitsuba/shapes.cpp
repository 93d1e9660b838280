#include "mitsuba/shapes.hpp"

#include "core/error.hpp"
#include "mitsuba/new_folder.hpp"
#include "scene/transform.hpp"

#include <algorithm>
#include <bit>
#include <fmt/format.h>

namespace sr::mitsuba {
namespace {

void write_shape(Output& output, const Triangles& triangles, std::string_view bsdf,
                 const std::optional<Emission>& emission) {
    const std::string file = fmt::format("meshes/{}.ply", output.mesh_count++);
    make_folder(output.folder / "meshes");
    write_ply(triangles, output.folder / file);
    output.xml.open("shape", "ply");
    output.xml.text("filename", file);
    output.xml.reference(bsdf);
    if (emission) write_area_emitter(output, *emission);
    output.xml.close();
}

float size_of(const Triangles& triangles) {
    scene::Bounds bounds;
    for (const vec3 position : triangles.positions) bounds.extend(position);
    return bounds.radius();
}

/// Adds the tangent space of normal maps and anisotropic lobes: vectors that are unit at the vertices and
/// interpolated from there (MikkTSpace).
void add_tangent_space(Triangles& triangles, const scene::Mesh& mesh, const mat4& world_from_object) {
    const float sign = scene::mirrors(world_from_object) ? -1.0f : 1.0f;
    VertexAttribute normal{"normal", triangles.normals}, tangent{"tangent", {}}, handedness{"handedness", {}};
    for (const vec4 t : mesh.tangents) {
        tangent.values.push_back(scene::unit_or(mat3(world_from_object) * vec3(t), vec3(0.0f)));
        handedness.values.emplace_back(sign * t.w);
    }
    triangles.attributes.insert(triangles.attributes.end(), {normal, tangent, handedness});
}

void write_instance(Output& output, const scene::Instance& instance) {
    const scene::Mesh& mesh = output.scene.meshes[static_cast<std::size_t>(instance.mesh)];
    const scene::Material& material = output.scene.materials[static_cast<std::size_t>(mesh.material)];
    if (mesh.indices.empty()) return;
    const std::string bsdf = output.materials.id_of(output.xml, mesh);
    std::optional<Emission> emission;
    if (material.is_emissive() && !material.is_unlit) {
        const scene::TextureSlot& slot = material.emission_texture;
        emission = Emission{material.emission, slot.texture, slot.uv_transform, material.is_double_sided};
    }
    write_mesh(output, triangles_of(output.scene, instance), bsdf, emission);
}

} // namespace

void write_area_emitter(Output& output, const Emission& emission) {
    output.xml.open("emitter", "area");
    if (emission.texture < 0)
        output.xml.color("radiance", emission.L);
    else
        output.textures.write(output.xml, "radiance", emission.texture, emission.uv_transform, Part::color,
                              emission.L);
    output.xml.close();
}

void write_mesh(Output& output, const Triangles& triangles, std::string_view bsdf,
                const std::optional<Emission>& emission) {
    if (!emission || !emission->is_two_sided) return write_shape(output, triangles, bsdf, emission);
    const float distance = 1e-5f * size_of(triangles);
    write_shape(output, moved(triangles, distance, false), bsdf, emission);
    write_shape(output, moved(triangles, -distance, true), bsdf, emission);
}

Triangles triangles_of(const scene::Scene& scene, const scene::Instance& instance) {
    const scene::Mesh& mesh = scene.meshes[static_cast<std::size_t>(instance.mesh)];
    const scene::Material& material = scene.materials[static_cast<std::size_t>(mesh.material)];
    const mat4& world_from_object = instance.world_from_object;
    const mat3 world_from_normal = scene::normal_transform(world_from_object);
    Triangles triangles;
    for (const vec3 position : mesh.positions)
        triangles.positions.emplace_back(world_from_object * vec4(position, 1.0f));
    for (const vec3 normal : mesh.normals)
        triangles.normals.push_back(scene::unit_or(world_from_normal * normal, vec3(0.0f)));
    triangles.uv = mesh.texcoords[texcoord_of(material)];
    if (!mesh.colors.empty()) {
        VertexAttribute color{"color", {}};
        for (const vec4 value : mesh.colors) color.values.emplace_back(value);
        triangles.attributes.push_back(color);
    }
    if (reads_tangents(material, mesh)) add_tangent_space(triangles, mesh, world_from_object);
    triangles.indices = mesh.indices;
    if (scene::mirrors(world_from_object)) // keeps the front in front
        for (std::size_t i = 0; i + 2 < triangles.indices.size(); i += 3)
            std::swap(triangles.indices[i], triangles.indices[i + 2]);
    return triangles;
}

void write_instances(Output& output) {
    const auto& meshes = output.scene.meshes;
    const auto lines =
        std::ranges::count_if(meshes, [](const scene::Mesh& mesh) { return !mesh.is_surface(); });
    if (lines > 0)
        output.warnings.push_back(
            fmt::format("{} mesh{} points or lines: not exported", lines, lines == 1 ? " is" : "es are"));
    for (const scene::Instance& instance : output.scene.instances) write_instance(output, instance);
}

namespace {

static_assert(std::endian::native == std::endian::little, "PLY files are written as the bytes lie in memory");

/// The PLY's body.
class Bytes {
public:
    template<typename T>
    void append(const T& value) {
        const auto* first = reinterpret_cast<const char*>(&value);
        text_.append(first, sizeof(T));
    }
    std::string& text() { return text_; }

private:
    std::string text_;
};

std::string header(const Triangles& triangles) {
    std::string text =
        fmt::format("ply\nformat binary_little_endian 1.0\nelement vertex {}\n", triangles.positions.size());
    const auto property = [&](std::string_view name) { text += fmt::format("property float {}\n", name); };
    for (const char* name : {"x", "y", "z"}) property(name);
    if (!triangles.normals.empty())
        for (const char* name : {"nx", "ny", "nz"}) property(name);
    if (!triangles.uv.empty())
        for (const char* name : {"u", "v"}) property(name);
    for (const VertexAttribute& attribute : triangles.attributes)
        for (const char* axis : {"x", "y", "z"}) property(attribute.name + "_" + axis);
    text += fmt::format("element face {}\nproperty list uchar int vertex_indices\nend_header\n",
                        triangles.indices.size() / 3);
    return text;
}

} // namespace

Triangles moved(Triangles triangles, float distance, bool turned) {
    require(triangles.normals.size() == triangles.positions.size(), "every vertex has a normal");
    for (std::size_t i = 0; i < triangles.positions.size(); ++i) {
        const vec3 n = scene::unit_or(triangles.normals[i], vec3(0.0f));
        triangles.positions[i] += distance * n;
        if (turned) triangles.normals[i] = -n;
    }
    if (turned)
        for (std::size_t i = 0; i + 2 < triangles.indices.size(); i += 3)
            std::swap(triangles.indices[i], triangles.indices[i + 2]);
    return triangles;
}

void write_ply(const Triangles& triangles, const std::filesystem::path& file) {
    Bytes bytes;
    bytes.text() = header(triangles);
    for (std::size_t i = 0; i < triangles.positions.size(); ++i) {
        bytes.append(triangles.positions[i]);
        if (!triangles.normals.empty()) bytes.append(triangles.normals[i]);
        if (!triangles.uv.empty()) bytes.append(triangles.uv[i]);
        for (const VertexAttribute& attribute : triangles.attributes) bytes.append(attribute.values[i]);
    }
    for (std::size_t i = 0; i + 2 < triangles.indices.size(); i += 3) {
        bytes.append(std::uint8_t{3});
        for (std::size_t k = 0; k < 3; ++k) bytes.append(static_cast<std::int32_t>(triangles.indices[i + k]));
    }
    write_text(file, bytes.text());
}

} // namespace sr::mitsuba
