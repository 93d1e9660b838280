#pragma once
// Generated glTF scenes: every emitter, every layer and BRDF, textures in every slot, node hierarchies.
//
// A recipe fixes which emitters and surfaces a scene has and so which programs it takes; a seed makes the
// scene. Many scenes of one recipe are rendered with the programs of the first (support/generated.hpp).
#include "scene/material.hpp"
#include "support/made_gltf.hpp"

#include <optional>
#include <span>
#include <vector>

namespace sr::testing {

enum class Emitter {
    point,
    spot,
    sun,
    wide_point, // with a radius
    wide_spot,
    wide_sun, // with an angular diameter
    profile,  // EXT_lights_ies
    rectangle,
    textured_rectangle,
    area_rectangle, // EXT_lights_area
    disk,
    ellipse,
    sphere,
    tube,
    polygon,
};

enum class Surface {
    plain,    // glTF's metallic-roughness without textures
    colored,  // with vertex colours
    textured, // in every slot of glTF's core, of _specular and of _emissive_strength (not emission)
    mapped,   // with a normal map alone
    anisotropic,
    coated,
    sheen,
    film,
    masked,
    blended,
    unlit,
    glowing,          // emits; of any form
    glowing_quad,     // emits; a rectangle
    textured_glowing, // emits by its texture
    first_model,      // the first row of scene::brdf_models; the other rows follow
};

constexpr Surface surface_of(scene::Model model) {
    return static_cast<Surface>(static_cast<int>(Surface::first_model) + static_cast<int>(model));
}
constexpr std::optional<scene::Model> model_of(Surface surface) {
    if (surface < Surface::first_model) return std::nullopt;
    return static_cast<scene::Model>(static_cast<int>(surface) - static_cast<int>(Surface::first_model));
}

struct Recipe {
    const char* name;
    std::vector<Emitter> emitters; // one of each
    std::vector<Surface> surfaces; // one material of each; the first one's is that of the ground
    bool is_without_extent() const;
};

/// Recipes that have each emitter and each surface at least once.
std::span<const Recipe> recipes();

/// Extreme features that a scene may have.
struct Extremes {
    bool has_degenerate_meshes = false; // triangles without area, normals and tangents that are zero
    bool has_flattened_nodes = false;   // axes scaled to 0
    bool is_coplanar = false;           // surfaces, emitters and the camera's target share planes
    bool is_coincident = false;         // the same meshes at the same places, emitters on vertices
    bool has_extreme_factors = false;   // roughness, alpha, colours and the like at the ends of their ranges
    double max_length = 1.0;            // the whole scene is scaled by something between its inverse and it
};

/// A scene of about 3 m around the origin with a camera that looks at it, as a glTF file without other files.
MadeGltf random_scene(const Recipe& recipe, std::uint64_t seed, const Extremes& extremes = {});

} // namespace sr::testing
