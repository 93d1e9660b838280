#include "render/gpu/shader_library.hpp"

#include "render/gpu/blocks.hpp"
#include "render/visibility/gpu_casters.hpp"

#include <array>
#include <fmt/format.h>

namespace sr::render {
namespace {

/// Sampler names by texture unit, the order of scene::Slot.
/// What stands for a file as long as the user's own roots do not have it.
glsl::Root specialised(const Features& features, VisibilityTerm visibility) {
    constexpr std::array files{"none", "ray", "record", "answered", "map"};
    const char* file = files[static_cast<std::size_t>(visibility)];
    glsl::Files texts{{"interface/features.glsl", features.glsl()},
                      {"brdf/model.glsl", features.model_glsl()},
                      {"visibility/visibility.glsl", fmt::format("#include \"visibility/{}.glsl\"\n", file)}};
    if (visibility == VisibilityTerm::map) {
        texts["integrator/shadowed.glsl"] = "#include \"integrator/shadowed_by_maps.glsl\"\n";
        texts["integrator/point_on_light.glsl"] = "#include \"integrator/map_point_on_light.glsl\"\n";
    }
    return glsl::Root::memory("specialised", std::move(texts));
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
    program.bind_texture("answers", answers_unit);
    program.bind_texture("last_rays", last_rays_unit);
    program.bind_texture("map_triangles", map_triangles_unit);
    program.bind_texture("map_points", map_points_unit);
    for (unsigned i = 0; i < caster_sampler_names.size(); ++i)
        program.bind_texture(caster_sampler_names[i], static_cast<GLint>(first_caster_unit + i));
}

} // namespace

gl::Program ShaderLibrary::compiled(const std::string& vertex, const std::string& fragment,
                                    std::span<const glsl::Root> path) {
    const glsl::Source vertex_source = glsl::expand(path, vertex);
    const glsl::Source fragment_source = glsl::expand(path, fragment);
    if (trial_) trial_->try_out(vertex_source, fragment_source);
    loops_.insert(loops_.end(), fragment_source.loops.begin(), fragment_source.loops.end());
    gl::Program program(fragment, vertex_source, fragment_source);
    connect(program);
    return program;
}

const gl::Program& ShaderLibrary::mesh_program(const std::string& fragment, const Features& features,
                                               VisibilityTerm visibility) {
    const auto key = std::tuple(fragment, features, visibility);
    if (const auto found = mesh_programs_.find(key); found != mesh_programs_.end()) return found->second;
    // Behind the user's own roots: a folder that brings its own features.glsl means it.
    std::vector<glsl::Root> path{shader_path_.begin(), shader_path_.end() - 1};
    if (estimator_ && features.is_analytic()) path.push_back(*estimator_);
    path.push_back(specialised(features, visibility));
    path.push_back(shader_path_.back());
    return mesh_programs_.emplace(key, compiled("mesh.vert", fragment, path)).first->second;
}

const gl::Program& ShaderLibrary::fullscreen_program(const std::string& fragment) {
    if (const auto found = fullscreen_programs_.find(fragment); found != fullscreen_programs_.end())
        return found->second;
    return fullscreen_programs_.emplace(fragment, compiled("fullscreen.vert", fragment, shader_path_))
        .first->second;
}

} // namespace sr::render
