#pragma once
// Surfaces as Mitsuba's shapes, with what they reflect and what they emit.
#include "core/math.hpp"
#include "mitsuba/materials.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace sr::mitsuba {

/// Three numbers a vertex under a name of their own: Mitsuba's attribute "vertex_NAME".
struct VertexAttribute {
    std::string name;
    std::vector<vec3> values;
};

/// Triangles in world space [m]. Every non-empty vertex array has positions.size() elements.
struct Triangles {
    std::vector<vec3> positions;
    std::vector<vec3> normals;
    std::vector<vec2> uv; // (0, 0) is a picture's upper left corner, as in glTF and in Mitsuba's bitmaps
    std::vector<VertexAttribute> attributes;
    std::vector<std::uint32_t> indices; // counter-clockwise seen from the front
};

/// Moves every vertex along the normal of its triangles by `distance` [m]; turned: then faces the other way.
/// Normals must be there.
Triangles moved(Triangles triangles, float distance, bool turned);

/// Binary little-endian PLY. @throws Error if the file cannot be written.
void write_ply(const Triangles& triangles, const std::filesystem::path& file);

/// A scene on its way into a folder.
struct Output {
    const scene::Scene& scene;
    std::filesystem::path folder;
    Xml xml{};
    Textures textures{scene, folder};
    Materials materials{scene, textures, folder};
    int mesh_count = 0;
    std::vector<std::string> warnings{};
};

/// Emission of a surface: a radiance L, times a texture.
struct Emission {
    vec3 L{0.0f};
    int texture = -1; // index into Scene::textures; negative: none
    mat3 uv_transform{1.0f};
    bool is_two_sided = false;
};

/// Writes the <emitter> of an open <shape>. @throws Error as Textures
void write_area_emitter(Output& output, const Emission& emission);

/// Writes a mesh's file and its <shape>, an emitter too if asked. Mitsuba's emitters have one side: a second
/// shape with its front behind, a 10^-5 of the mesh's size away, does for the other. @throws Error
void write_mesh(Output& output, const Triangles& triangles, std::string_view bsdf,
                const std::optional<Emission>& emission);

/// The instance's mesh in world space, its front where the instance's is.
Triangles triangles_of(const scene::Scene& scene, const scene::Instance& instance);

/// Writes every instance of the scene. @throws Error
void write_instances(Output& output);

} // namespace sr::mitsuba
