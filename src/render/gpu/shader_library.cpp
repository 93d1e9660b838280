#include "render/gpu/shader_library.hpp"

#include "core/error.hpp"
#include "gl/context.hpp"
#include "glsl/loops.hpp"
#include "glsl/source.hpp"
#include "render/gpu/blocks.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>

namespace sr::render {
namespace {

/// The functions that a file of brdf/models/ declares (shaders/brdf/brdf.glsl).
constexpr std::array<std::string_view, 9> brdf_functions{
    "f_r",   "has_peak",         "sample_f_r",        "pdf_f_r",        "peak_alpha",
    "lobes", "has_diffuse_lobe", "has_specular_lobe", "specular_albedo"};

/// The files that are specialised, behind the user's own roots.
glsl::Root specialised(const Features& features, VisibilityTerm visibility,
                       std::span<const glsl::Root> path) {
    constexpr std::array files{"none", "ray", "record", "resolve", "map", "none"};
    const char* file = files[static_cast<std::size_t>(visibility)];
    glsl::Files texts = brdf_files(features.is_matte ? scene::Model::lambert : features.model, path);
    texts["interface/features.glsl"] = features.glsl();
    texts["visibility/visibility.glsl"] = fmt::format("#include \"visibility/{}.glsl\"\n", file);
    if (visibility == VisibilityTerm::defer)
        texts["visibility/seen.glsl"] = "#include \"visibility/deferred.glsl\"\n";
    if (visibility == VisibilityTerm::map) {
        texts["integrator/shadowed.glsl"] = "#include \"integrator/shadowed_by_maps.glsl\"\n";
        texts["integrator/point_on_light.glsl"] = "#include \"integrator/map_point_on_light.glsl\"\n";
    }
    return glsl::Root::memory("specialised", std::move(texts));
}

/// The files with which a sample chooses this many lights.
glsl::Root chosen_lights(int choices) {
    std::string text = *glsl::embedded().text_of("interface/estimator.glsl");
    const std::string_view none = "light_choices = 0";
    const auto place = text.find(none);
    require(place != std::string::npos, "interface/estimator.glsl declares light_choices");
    text.replace(place, none.size(), fmt::format("light_choices = {}", choices));
    return glsl::Root::memory(
        "chosen lights", {{"integrator/reflected.glsl", "#include \"integrator/reflected_from_one.glsl\"\n"},
                          {"interface/estimator.glsl", text}});
}

/// The shader with its loops inverted; absent if it has none to invert, or what is no GLSL.
std::optional<glsl::Source> with_inverted_loops(const glsl::Source& source) {
    glsl::Source inverted = source;
    try {
        inverted.text = glsl::invert_loops(source.text);
    } catch (const Error&) { // the driver says it better
        return std::nullopt;
    }
    if (inverted.text == source.text) return std::nullopt;
    return inverted;
}

} // namespace

glsl::Files brdf_files(scene::Model model, std::span<const glsl::Root> path) {
    const std::string include = fmt::format("#include \"brdf/models/{}.glsl\"\n", scene::name_of(model));
    glsl::Files files{{"brdf/f_r.glsl", include}};
    const auto has_own = [](const glsl::Root& root) { return root.text_of("brdf/f_r.glsl").has_value(); };
    if (std::ranges::none_of(path.first(path.size() - 1), has_own)) return files;
    const std::string own = glsl::expand(path, "brdf/f_r.glsl").text;
    std::string before = "#include \"brdf/f_r.glsl\"\n", after;
    for (const std::string_view name : brdf_functions) {
        if (name != "f_r" && !glsl::declares(own, name)) continue;
        before += fmt::format("#define {0} model_{0}\n", name);
        after += fmt::format("#undef {}\n", name);
    }
    files["brdf/brdf.glsl"] = before + include + after;
    return files;
}

gl::Program ShaderLibrary::compiled(const std::string& vertex, const std::string& fragment,
                                    std::span<const glsl::Root> path) {
    const glsl::Source vertex_source = glsl::expand(path, vertex);
    const glsl::Source fragment_source = glsl::expand(path, fragment);
    loops_.insert(loops_.end(), fragment_source.loops.begin(), fragment_source.loops.end());
    if (gl::is_software_renderer(reinterpret_cast<const char*>(glGetString(GL_RENDERER)))) {
        if (const std::optional<glsl::Source> inverted = with_inverted_loops(fragment_source)) {
            try {
                return linked(fragment, vertex_source, *inverted);
            } catch (const gl::ShaderError&) { // the driver's log is to name columns of the text as it is
            }
        }
    }
    return linked(fragment, vertex_source, fragment_source);
}

gl::Program ShaderLibrary::linked(const std::string& name, const glsl::Source& vertex,
                                  const glsl::Source& fragment) {
    if (trial_) trial_->try_out(vertex, fragment);
    gl::Program program(name, vertex, fragment);
    connect(program);
    return program;
}

/// Behind the user's own roots: a folder that brings its own features.glsl means it.
std::vector<glsl::Root> ShaderLibrary::path_of(const Features& features, ProgramTerms terms) const {
    std::vector<glsl::Root> path{shader_path_.begin(), shader_path_.end() - 1};
    if (estimator_ && features.is_analytic()) path.push_back(*estimator_);
    if (terms.light_choices > 0) path.push_back(chosen_lights(terms.light_choices));
    path.push_back(specialised(features, terms.visibility, shader_path_));
    path.push_back(shader_path_.back());
    return path;
}

const gl::Program& ShaderLibrary::mesh_program(const std::string& fragment, const Features& features,
                                               ProgramTerms terms) {
    Features asked = features;
    if (shader_path_.size() > 1) asked.is_matte = false; // a user's folder may change any file of the BRDF
    const Key key(fragment, asked, terms);
    if (const auto found = mesh_programs_.find(key); found != mesh_programs_.end()) return found->second;
    return mesh_programs_.emplace(key, compiled("mesh.vert", fragment, path_of(asked, terms))).first->second;
}

const gl::Program& ShaderLibrary::pixel_program(const std::string& fragment, const Features& features,
                                                ProgramTerms terms) {
    const Key key(fragment, features, terms);
    if (const auto found = pixel_programs_.find(key); found != pixel_programs_.end()) return found->second;
    std::vector<glsl::Root> path = path_of(features, terms);
    path.insert(path.end() - 1,
                glsl::Root::memory("pixel by pixel", {{"interface/fragment.glsl",
                                                       "#include \"interface/seen_triangle.glsl\"\n"}}));
    return pixel_programs_.emplace(key, compiled("fullscreen.vert", fragment, path)).first->second;
}

const gl::Program& ShaderLibrary::fullscreen_program(const std::string& fragment) {
    if (const auto found = fullscreen_programs_.find(fragment); found != fullscreen_programs_.end())
        return found->second;
    return fullscreen_programs_.emplace(fragment, compiled("fullscreen.vert", fragment, shader_path_))
        .first->second;
}

} // namespace sr::render
