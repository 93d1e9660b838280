#pragma once
// C++ side of the uniform blocks in shaders/interface/ (std140; a test compares the layouts with the
// linker's), and the texture units.
#include "core/math.hpp"
#include "gl/object.hpp"
#include "gl/program.hpp"
#include "scene/material.hpp"
#include "scene/measured_brdf.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

namespace sr::render {

/// Binding points.
enum Block : unsigned { frame_block = 0, object_block = 1, material_block = 2, rays_block = 3 };

struct FrameBlock {
    mat4 clip_from_world;
    vec4 eye;
    std::uint32_t sample_index;
    std::uint32_t seed;
    std::int32_t first_light;
    std::int32_t end_light;
    vec2 frame_size;
    vec2 padding{0.0f};
    std::array<std::uint32_t, 4> sample_digits{}; // render::sample_digits()
};

struct ObjectBlock {
    mat4 world_from_object;
    mat4 world_from_normal;
    vec4 handedness;
    std::int32_t first_triangle;
    std::int32_t object;
    std::int32_t material;
    std::int32_t first_normal = -1;
    std::int32_t first_tangent = -1;
    std::int32_t first_uv0 = -1;
    std::int32_t first_uv1 = -1;
    std::int32_t first_color = -1;
};

struct RaysBlock {
    std::int32_t first_ray;
    std::int32_t plane_size;
    std::int32_t row_size;
    std::int32_t first_row;
    std::int32_t most_rays = 0;
    std::int32_t unused[3]{};
};

/// Texture units: a material's slots (scene::texture_inputs, also indices into the uv rows of MaterialBlock),
/// and behind them what is not the material's. OpenGL 4.1 has 80 units in all; what is scarce is how many one
/// shader reads (16 are certain), and which these are the features decide (ShaderLibrary counts them).
using scene::slot_count;
inline constexpr unsigned light_table_unit = slot_count;
inline constexpr unsigned emission_texels_unit = slot_count + 1;
inline constexpr unsigned ray_visibility_unit = slot_count + 2;
inline constexpr unsigned ltc_table_unit = slot_count + 3;
inline constexpr unsigned last_rays_unit = slot_count + 4;
inline constexpr unsigned map_triangles_unit = ray_visibility_unit; // depth maps take the place of rays
inline constexpr unsigned map_points_unit = last_rays_unit;
inline constexpr unsigned first_caster_unit = slot_count + 5; // five of them, see gpu_casters.hpp
inline constexpr unsigned measured_unit = slot_count + 10;
inline constexpr unsigned environment_texels_unit = slot_count + 11;
inline constexpr unsigned mesh_floats_unit = slot_count + 12;
inline constexpr unsigned mesh_indices_unit = slot_count + 13;
inline constexpr unsigned seen_triangles_unit = slot_count + 14;
inline constexpr unsigned triangle_numbers_unit = mesh_indices_unit; // the depth pass has no mesh to look up

/// A number takes a vec4, and so does a colour; an index of refraction takes two, a measured BRDF one (its
/// alpha).
inline constexpr std::size_t max_model_parameters = 4;

/// The factors of a material's textures and layers that fill a vec4 of the block `Material`.
struct MaterialFactor {
    const char* name; // of shaders/interface/material.glsl, which says what is in it
    vec4 (*of)(const scene::Material&);
};

/// All of them, in the order of the block.
inline constexpr std::array material_factors{
    MaterialFactor{"base_color_factor", [](const scene::Material& m) { return m.base_color; }},
    MaterialFactor{"emission_factor", [](const scene::Material& m) { return vec4(m.emission, 0.0f); }},
    MaterialFactor{"specular_color_factor",
                   [](const scene::Material& m) { return vec4(m.specular_color, m.specular); }},
    MaterialFactor{"anisotropy_factor",
                   [](const scene::Material& m) {
                       return vec4(m.anisotropy, std::cos(m.anisotropy_rotation),
                                   std::sin(m.anisotropy_rotation), 0.0f);
                   }},
    MaterialFactor{"clearcoat_factor",
                   [](const scene::Material& m) {
                       return vec4(m.clearcoat, m.clearcoat_roughness, m.clearcoat_normal_scale, 0.0f);
                   }},
    MaterialFactor{"sheen_factor",
                   [](const scene::Material& m) { return vec4(m.sheen_color, m.sheen_roughness); }},
    MaterialFactor{"iridescence_factor",
                   [](const scene::Material& m) {
                       return vec4(m.iridescence, m.film_ior, m.min_film_thickness, m.max_film_thickness);
                   }},
    MaterialFactor{"transmission_factor",
                   [](const scene::Material& m) { return vec4(m.transmission, m.thickness, 0.0f, 0.0f); }},
    MaterialFactor{"attenuation_factor",
                   [](const scene::Material& m) { return vec4(scene::attenuation_coefficient(m), 0.0f); }},
    MaterialFactor{"diffuse_transmission_factor", [](const scene::Material& m) {
                       return vec4(m.diffuse_transmission_color, m.diffuse_transmission);
                   }}};

struct MaterialBlock {
    std::array<vec4, material_factors.size()> factors;
    std::array<vec4, max_model_parameters> model_parameters;
    float metallic_factor;
    float roughness_factor;
    float normal_scale;
    float alpha_cutoff;
    float F0_from_ior;
    std::array<float, 3> padding{};
    std::array<vec4, slot_count> uv_row_u;
    std::array<vec4, slot_count> uv_row_v;
};

/// `measured`: the measured BRDFs of the scene, which Material::measured counts.
MaterialBlock pack_material(const scene::Material& material, std::span<const scene::MeasuredBrdf> measured);

/// Connects the blocks and samplers of shaders/interface/ and of the terms with their binding points and
/// units.
void connect(const gl::Program& program);

/// Uniform buffer of a FrameBlock.
class FrameData {
public:
    /// Uploads the block and binds it.
    void upload(const FrameBlock& block);
    /// Uploads the last block again with the lights [first, end).
    void select_lights(int first, int end);

private:
    gl::Buffer buffer_{"frame"};
    FrameBlock block_{};
};

} // namespace sr::render
