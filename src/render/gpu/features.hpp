#pragma once
// Features of a shader program: constants that overlay shaders/interface/features.glsl. The compiler drops
// the code that a scene does not use. (One program for everything costs seconds of compile time in software
// GL.)
#include "scene/scene.hpp"

#include <array>
#include <compare>
#include <span>
#include <string>
#include <string_view>

namespace sr::render {

struct Features {
    std::array<bool, scene::light_kind_count>
        has_lights{}; // by kind; a point or spot with a radius is a sphere
    bool has_sun_disks = false;
    bool has_profiles = false;
    bool has_emission_maps = false;
    bool has_environment_maps = false;

    std::array<bool, scene::slot_count> has_texture{}; // by slot
    bool has_packed_metallic_roughness = false;        // TexturePacking
    bool has_second_uv = false;                        // a texture reads the second set of coordinates
    bool has_vertex_colors = false;

    scene::Model model = scene::Model::metallic_roughness;
    std::array<bool, scene::layer_count> has_layer{}; // by Layer
    bool has_energy_compensation = false;
    bool is_specular_glossiness = false;
    bool is_matte = false; // of metallic_roughness only Lambert's part is left

    bool is_opaque_part = false; // of glass, only what its textures keep opaque is drawn

    int rays_per_light = 1;               // that a point sends to each light
    bool has_transparent_casters = false; // surfaces that are masked, blended or of glass cast shadows
    bool has_tinted_casters = false;      // glass does

    bool is_masked = false;
    bool is_blended = false;
    bool is_unlit = false;
    bool is_line = false; // drawn a few pixels wide
    bool is_point = false;

    auto operator<=>(const Features&) const = default;

    /// Returns the flag of the light kind L: true if there are such lights.
    template<class L>
    bool& has() {
        return has_lights[scene::light_kind<L>()];
    }

    bool& has(scene::TextureSlot scene::Material::*texture) {
        return has_texture[scene::texture_slot(texture)];
    }
    bool has(scene::TextureSlot scene::Material::*texture) const {
        return has_texture[scene::texture_slot(texture)];
    }

    bool& has(scene::Layer layer) { return has_layer[static_cast<std::size_t>(layer)]; }
    bool has(scene::Layer layer) const { return has_layer[static_cast<std::size_t>(layer)]; }

    /// The text that stands for interface/features.glsl.
    std::string glsl() const;

    /// True if a texture can make parts of glass opaque. These hide what is behind like other surfaces.
    bool may_have_opaque_part() const {
        return has(scene::Layer::transmission) && !is_blended
               && (has(&scene::Material::transmission_texture)
                   || has(&scene::Material::metallic_roughness_texture));
    }

    /// True if the analytic estimator can evaluate the BRDF: it has one isotropic GGX lobe, or none.
    /// Other BRDFs are sampled.
    bool is_analytic() const;

    /// Returns the number of the material's textures that shading reads.
    int material_texture_count() const;
};

/// Returns the features that these lights need on every surface. A shaded point sends each light a ray to a
/// point on it. If a direction sampled from the BRDF can hit any of the lights, the shaded point sends each
/// light a second ray along such a direction.
Features light_features(std::span<const scene::Light> lights);

/// True if any surface of the scene is masked, blended or of glass, and so lets some light through.
bool has_transparent_casters(const scene::Scene& scene);
/// True if any surface of the scene is of glass, so that V has a colour.
bool has_tinted_casters(const scene::Scene& scene);

/// Returns the features that the shading of this mesh needs; `lights` are those that the lights need.
Features shading_features(const scene::Scene& scene, const scene::Mesh& mesh, const Features& lights);

/// @throws Error if the material of that name takes more than `units` textures together with lights and
/// shadows; OpenGL grants 16 at least, GL_MAX_TEXTURE_IMAGE_UNITS
void require_texture_units(const Features& features, std::string_view material, int units);

/// Returns whether a driver with so many units has room for the mesh's arrays besides (TriangleBuffer).
bool has_room_for_mesh(const Features& features, int units);

/// Returns the features of `shading` that the depth pre-pass needs: the kind of primitive, and the features
/// of alpha and transmission if the material is masked or glass in part.
Features depth_features(const Features& shading);

/// Returns the features of `shading` that depth maps need: the kind of primitive, and the features of alpha
/// unless the material is opaque.
Features caster_features(const Features& shading);

} // namespace sr::render
