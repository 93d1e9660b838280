#pragma once
// The programs of a scene: compiled once for every set of features that it has.
#include "gl/program.hpp"
#include "gl/trial_compiler.hpp"
#include "glsl/root.hpp"
#include "glsl/untrusted.hpp"
#include "render/gpu/features.hpp"

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <vector>

namespace sr::render {

/// The file that is compiled as shaders/visibility/visibility.glsl.
/// `defer` leaves V to the CPU, and puts visibility/deferred.glsl in the place of visibility/seen.glsl.
enum class VisibilityTerm { none, ray, record, resolve, map, defer };

/// The terms of the equation that the renderer chooses, besides those that features choose.
struct ProgramTerms {
    VisibilityTerm visibility = VisibilityTerm::none;
    int light_choices = 0; // above 0: of a sample, by integrator/reflected_from_one.glsl

    ProgramTerms(VisibilityTerm chosen = VisibilityTerm::none, int choices = 0)
        : visibility(chosen), light_choices(choices) {}
    auto operator<=>(const ProgramTerms&) const = default;
};

/// The files that put a BRDF in the place of brdf/f_r.glsl, behind the user's own roots, which are all of
/// `path` but the last. Where one of those has that file, brdf/brdf.glsl adds from the model what it does not
/// declare.
/// @throws Error if the user's file cannot be expanded
glsl::Files brdf_files(scene::Model model, std::span<const glsl::Root> path);

class ShaderLibrary {
public:
    /// `shader_path`: the roots that shaders come from; the first that has a file wins.
    /// `estimator` stands behind the user's own roots, for materials that the analytic estimator can take.
    /// `trial` tries what the user's roots bring; null: it is compiled at once.
    explicit ShaderLibrary(std::vector<glsl::Root> shader_path, std::optional<glsl::Root> estimator = {},
                           std::shared_ptr<gl::TrialCompiler> trial = nullptr)
        : shader_path_(std::move(shader_path)), estimator_(std::move(estimator)), trial_(std::move(trial)) {}

    /// mesh.vert with `fragment` ("depth.frag", "forward.frag") for these features. Compiles at the first
    /// call.
    /// @throws ShaderError, Error
    const gl::Program& mesh_program(const std::string& fragment, const Features& features,
                                    ProgramTerms terms = {});

    /// The same for pixels that look their triangle up (shaders/interface/seen_triangle.glsl):
    /// fullscreen.vert with `fragment`. @throws ShaderError, Error
    const gl::Program& pixel_program(const std::string& fragment, const Features& features,
                                     ProgramTerms terms = {});

    /// fullscreen.vert with `fragment`. Compiles at the first call. @throws ShaderError, Error
    const gl::Program& fullscreen_program(const std::string& fragment);

    /// The loops of untrusted code in all programs.
    const std::vector<glsl::Loop>& loops() const { return loops_; }

    std::size_t program_count() const {
        return mesh_programs_.size() + pixel_programs_.size() + fullscreen_programs_.size();
    }

private:
    using Key = std::tuple<std::string, Features, ProgramTerms>;

    std::vector<glsl::Root> path_of(const Features& features, ProgramTerms terms) const;
    gl::Program compiled(const std::string& vertex, const std::string& fragment,
                         std::span<const glsl::Root> path);
    gl::Program linked(const std::string& name, const glsl::Source& vertex, const glsl::Source& fragment);

    std::vector<glsl::Root> shader_path_;
    std::optional<glsl::Root> estimator_;
    std::shared_ptr<gl::TrialCompiler> trial_;
    std::vector<glsl::Loop> loops_;
    std::map<Key, gl::Program> mesh_programs_;
    std::map<Key, gl::Program> pixel_programs_;
    std::map<std::string, gl::Program> fullscreen_programs_;
};

} // namespace sr::render
