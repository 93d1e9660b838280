#include "render/gpu/blocks.hpp"

#include "core/error.hpp"
#include "render/visibility/gpu_casters.hpp"

#include <fmt/format.h>
#include <variant>

namespace sr::render {
namespace {

/// The parameters of the material's BRDF in the order of scene::brdf_parameters.
std::array<vec4, max_model_parameters> model_parameters(const scene::Material& m,
                                                        std::span<const scene::MeasuredBrdf> measured) {
    struct Packing {
        const scene::Material& m;
        std::span<const scene::MeasuredBrdf> measured;
        std::array<vec4, max_model_parameters> packed{};
        std::size_t count = 0;

        void add(vec4 value) {
            require(count < packed.size(), "a BRDF has no more parameters than the block has room for");
            packed[count++] = value;
        }
        void operator()(float scene::Material::*number) { add(vec4(m.*number, 0.0f, 0.0f, 0.0f)); }
        void operator()(vec3 scene::Material::*color) { add(vec4(m.*color, 0.0f)); }
        void operator()(scene::ComplexIor scene::Material::*ior) {
            add(vec4((m.*ior).n, 0.0f));
            add(vec4((m.*ior).k, 0.0f));
        }
        void operator()(int scene::Material::*index) {
            const int i = m.*index;
            add(vec4(i < 0 ? 1.0f : measured[static_cast<std::size_t>(i)].alpha, 0.0f, 0.0f, 0.0f));
        }
    };
    Packing packing{m, measured};
    for (const scene::BrdfParameter& parameter : scene::brdf_parameters)
        if (parameter.is_of(m.model) && !parameter.is_alternative)
            std::visit([&](auto member) { packing(member); }, parameter.member);
    return packing.packed;
}

} // namespace

MaterialBlock pack_material(const scene::Material& m, std::span<const scene::MeasuredBrdf> measured) {
    MaterialBlock block{};
    for (std::size_t i = 0; i < material_factors.size(); ++i) block.factors[i] = material_factors[i].of(m);
    block.model_parameters = model_parameters(m, measured);
    block.metallic_factor = m.metallic;
    block.roughness_factor = m.roughness;
    block.normal_scale = m.normal_scale;
    block.alpha_cutoff = scene::min_opaque_alpha(m);
    block.F0_from_ior = scene::F0_from_ior(m.ior);
    for (std::size_t s = 0; s < slot_count; ++s) {
        const scene::TextureSlot& texture = m.*scene::texture_inputs[s].member;
        const mat3 rows = glm::transpose(texture.uv_transform);
        const auto set = static_cast<float>(texture.texcoord);
        block.uv_row_u[s] = vec4(rows[0], set);
        block.uv_row_v[s] = vec4(rows[1], set);
    }
    return block;
}

void connect(const gl::Program& program) {
    program.bind_block("Frame", frame_block);
    program.bind_block("Object", object_block);
    program.bind_block("Material", material_block);
    program.bind_block("Rays", rays_block);
    for (unsigned unit = 0; unit < slot_count; ++unit)
        program.bind_texture(fmt::format("{}_texture", scene::texture_inputs[unit].name).c_str(),
                             static_cast<GLint>(unit));
    program.bind_texture("light_table", light_table_unit);
    program.bind_texture("emission_texels", emission_texels_unit);
    program.bind_texture("environment_texels", environment_texels_unit);
    program.bind_texture("ltc_table", ltc_table_unit);
    program.bind_texture("measured_brdf", measured_unit);
    program.bind_texture("ray_visibility", ray_visibility_unit);
    program.bind_texture("last_rays", last_rays_unit);
    program.bind_texture("map_triangles", map_triangles_unit);
    program.bind_texture("map_points", map_points_unit);
    program.bind_texture("mesh_floats", mesh_floats_unit);
    program.bind_texture("mesh_indices", mesh_indices_unit);
    program.bind_texture("seen_triangles", seen_triangles_unit);
    program.bind_texture("triangle_numbers", triangle_numbers_unit);
    for (unsigned i = 0; i < caster_sampler_names.size(); ++i)
        program.bind_texture(caster_sampler_names[i], static_cast<GLint>(first_caster_unit + i));
}

void FrameData::upload(const FrameBlock& block) {
    block_ = block;
    glBindBuffer(GL_UNIFORM_BUFFER, buffer_.id());
    glBufferData(GL_UNIFORM_BUFFER, sizeof(block_), &block_, GL_STREAM_DRAW);
    glBindBufferBase(GL_UNIFORM_BUFFER, frame_block, buffer_.id());
}

void FrameData::select_lights(int first, int end) {
    FrameBlock block = block_;
    block.first_light = first;
    block.end_light = end;
    upload(block);
}

} // namespace sr::render
