#include "render/shader_library.hpp"

#include "render/blocks.hpp"

#include <array>

namespace sr::render {
namespace {

/// Sampler names by texture unit, the order of Slot.
constexpr std::array<const char*, slot_count> sampler_names{
    "base_color_texture", "metallic_roughness_texture", "normal_texture",
    "emission_texture",   "specular_texture",           "specular_color_texture"};

} // namespace

const gl::Program& ShaderLibrary::mesh_program(const std::string& fragment, const Features& features) {
    const auto key = std::pair(fragment, features);
    if (const auto found = mesh_programs_.find(key); found != mesh_programs_.end()) return found->second;
    // Behind the user's own roots: a folder that brings its own features.glsl means it.
    std::vector<glsl::Root> path{shader_path_.begin(), shader_path_.end() - 1};
    path.push_back(glsl::Root::memory("features", {{"interface/features.glsl", features.glsl()}}));
    path.push_back(shader_path_.back());
    gl::Program program(fragment, glsl::expand(path, "mesh.vert"), glsl::expand(path, fragment));
    program.bind_block("Frame", frame_block);
    program.bind_block("Object", object_block);
    program.bind_block("Material", material_block);
    for (unsigned unit = 0; unit < slot_count; ++unit)
        program.bind_texture(sampler_names[unit], static_cast<GLint>(unit));
    program.bind_texture("light_table", light_table_unit);
    program.bind_texture("emission_texels", emission_texels_unit);
    program.bind_texture("ltc_table", ltc_table_unit);
    return mesh_programs_.emplace(key, std::move(program)).first->second;
}

const gl::Program& ShaderLibrary::fullscreen_program(const std::string& fragment) {
    if (const auto found = fullscreen_programs_.find(fragment); found != fullscreen_programs_.end())
        return found->second;
    gl::Program program(fragment, glsl::expand(shader_path_, "fullscreen.vert"),
                        glsl::expand(shader_path_, fragment));
    return fullscreen_programs_.emplace(fragment, std::move(program)).first->second;
}

} // namespace sr::render
