#include "render/gpu/blocks.hpp"

#include "render/gpu/shader_library.hpp"
#include "support/address.hpp"
#include "support/gl.hpp"

#include <cstddef>

using namespace sr;
using namespace sr::render;
using sr::testing::Test;

namespace {

/// Everything on, so that the linker drops no member that some material uses.
Features everything() {
    Features f;
    f.has_lights.fill(true);
    f.has_sun_disks = f.has_profiles = f.has_emission_maps = true;
    f.has_texture.fill(true);
    f.has_second_uv = f.has_vertex_colors = f.is_masked = f.is_blended = true;
    f.has_layer.fill(true);
    return f;
}

GLint offset_of(const gl::Program& program, const char* member) {
    GLuint index = GL_INVALID_INDEX;
    glGetUniformIndices(program.id(), 1, &member, &index);
    GLint offset = -1;
    if (index != GL_INVALID_INDEX) glGetActiveUniformsiv(program.id(), 1, &index, GL_UNIFORM_OFFSET, &offset);
    return offset;
}

GLint size_of(const gl::Program& program, const char* block) {
    GLint size = -1;
    glGetActiveUniformBlockiv(program.id(), glGetUniformBlockIndex(program.id(), block),
                              GL_UNIFORM_BLOCK_DATA_SIZE, &size);
    return size;
}

// The blocks are std140 on both sides; a member that moves on one side only would be read as another.
const Test layout("unit.render.blocks.match_the_shaders", [] {
    sr::testing::context();
    ShaderLibrary shaders({glsl::embedded()});
    const gl::Program& program = shaders.mesh_program("forward.frag", everything(), VisibilityTerm::ray);

    EXPECT_EQ(offset_of(program, "clip_from_world"), offsetof(FrameBlock, clip_from_world));
    EXPECT_EQ(offset_of(program, "eye"), offsetof(FrameBlock, eye));
    EXPECT_EQ(offset_of(program, "sample_index"), offsetof(FrameBlock, sample_index));
    EXPECT_EQ(offset_of(program, "seed"), offsetof(FrameBlock, seed));
    EXPECT_EQ(offset_of(program, "first_light"), offsetof(FrameBlock, first_light));
    EXPECT_EQ(offset_of(program, "end_light"), offsetof(FrameBlock, end_light));
    EXPECT_EQ(offset_of(program, "frame_size"), offsetof(FrameBlock, frame_size));
    EXPECT_EQ(offset_of(program, "sample_digits"), offsetof(FrameBlock, sample_digits));
    EXPECT_LE(size_of(program, "Frame"), static_cast<GLint>(sizeof(FrameBlock)));

    EXPECT_EQ(offset_of(program, "world_from_object"), offsetof(ObjectBlock, world_from_object));
    EXPECT_EQ(offset_of(program, "world_from_normal"), offsetof(ObjectBlock, world_from_normal));
    EXPECT_EQ(offset_of(program, "handedness"), offsetof(ObjectBlock, handedness));
    EXPECT_EQ(offset_of(program, "first_triangle"), offsetof(ObjectBlock, first_triangle));
    const gl::Program& numbers = shaders.mesh_program("views/ids_depth.frag", everything());
    EXPECT_EQ(offset_of(numbers, "object"), offsetof(ObjectBlock, object));
    EXPECT_EQ(offset_of(numbers, "material"), offsetof(ObjectBlock, material));
    EXPECT_LE(size_of(program, "Object"), static_cast<GLint>(sizeof(ObjectBlock)));

    for (std::size_t i = 0; i < material_factors.size(); ++i)
        EXPECT_EQ(offset_of(program, material_factors[i].name),
                  offsetof(MaterialBlock, factors) + i * sizeof(vec4))
            << material_factors[i].name;
    Features metal = everything();
    metal.model = scene::Model::conductor;
    EXPECT_EQ(offset_of(shaders.mesh_program("forward.frag", metal), "model_parameters[0]"),
              offsetof(MaterialBlock, model_parameters));
    EXPECT_EQ(offset_of(program, "metallic_factor"), offsetof(MaterialBlock, metallic_factor));
    EXPECT_EQ(offset_of(program, "roughness_factor"), offsetof(MaterialBlock, roughness_factor));
    EXPECT_EQ(offset_of(program, "normal_scale"), offsetof(MaterialBlock, normal_scale));
    EXPECT_EQ(offset_of(program, "alpha_cutoff"), offsetof(MaterialBlock, alpha_cutoff));
    EXPECT_EQ(offset_of(program, "F0_from_ior"), offsetof(MaterialBlock, F0_from_ior));
    EXPECT_EQ(offset_of(program, "uv_row_u[0]"), offsetof(MaterialBlock, uv_row_u));
    EXPECT_EQ(offset_of(program, "uv_row_v[0]"), offsetof(MaterialBlock, uv_row_v));
    EXPECT_LE(size_of(program, "Material"), static_cast<GLint>(sizeof(MaterialBlock)));
});

const Test rays("unit.render.blocks.rays_match_the_shader", [] {
    sr::testing::context();
    ShaderLibrary shaders({glsl::embedded()});
    const gl::Program& program = shaders.mesh_program("forward.frag", everything(), VisibilityTerm::resolve);
    EXPECT_EQ(offset_of(program, "first_ray"), offsetof(RaysBlock, first_ray));
    EXPECT_EQ(offset_of(program, "plane_size"), offsetof(RaysBlock, plane_size));
    EXPECT_EQ(offset_of(program, "row_size"), offsetof(RaysBlock, row_size));
    EXPECT_EQ(offset_of(program, "first_row"), offsetof(RaysBlock, first_row));
});

} // namespace
