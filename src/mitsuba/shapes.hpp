#pragma once
// Surfaces as Mitsuba's shapes, with what they reflect and what they emit.
#include "mitsuba/materials.hpp"
#include "mitsuba/triangles.hpp"

#include <optional>

namespace sr::mitsuba {

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
