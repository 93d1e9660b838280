#pragma once
// The options of `steradian render`, one struct with the defaults.
#include "cli/aovs.hpp"
#include "cli/arguments.hpp"
#include "cli/frame_names.hpp"
#include "cli/stopping.hpp"
#include "cli/views.hpp"
#include "gl/context.hpp"
#include "image/display.hpp"
#include "image/file.hpp"
#include "render/renderer.hpp"
#include "render/visibility/visibility_backend.hpp"
#include "scene/prepare.hpp"

namespace CLI {
class App;
}

namespace sr::cli {

/// What --environment and its kin say.
struct EnvironmentArguments {
    std::string source; // a file, or L, or R,G,B [cd/m²]; empty: none
    float degrees = 0.0f;
    float strength = 1.0f;
    bool is_hidden = false;

    /// Reads the file; warnings go to stderr. @throws Error
    std::optional<scene::EnvironmentLight> light() const;
};

struct RenderCommand {
    std::string scene;
    std::vector<std::string> outputs; // one rendering, written in each form
    std::optional<Size> size;         // absent: 720 rows in the camera's aspect ratio, 16:9 if it has none
    std::string camera;
    std::optional<int> scene_index;
    std::string variant;              // of KHR_materials_variants; empty: none
    std::string animation;            // by name, by index, or "all"; empty: the first
    std::optional<double> at;         // [s]; absent: the file's rest pose
    std::optional<FrameRange> frames; // a sequence of pictures instead of one
    double fps = 24.0;
    StopRule stop;
    render::Visibility visibility = render::Visibility::ray;
    render::MapOptions maps;
    std::uint32_t seed = 0;
    render::Estimator estimator = render::Estimator::sampled;
    int analytic_points = render::default_analytic_points;
    vec3 background{0.0f};
    scene::Rig rig = scene::Rig::automatic;
    EnvironmentArguments environment;
    bool has_energy_compensation = false;
    bool hide_emitters = false;
    std::optional<float> ev100; // absent: automatic
    image::ToneCurve tone_curve = image::ToneCurve::neutral;
    bool light_layers = false;  // in .exr: a layer a light
    std::vector<Aov> aovs;      // in .exr: further channels
    bool denoises = false;      // the shadows of the analytic estimator
    const View* view = nullptr; // one term instead of radiance

    /// Whether the picture has to know its error, that is, takes its samples from two sequences.
    bool asks_for_error() const;
    image::SampleType exr_type = image::SampleType::floating;
    gl::Backend backend = gl::Backend::automatic;
    bool gl_debug = false;
    std::vector<std::string> shaders;
    bool is_strict = false; // what the file has broken is an error, and no warning
    bool json = false;
};

/// What --strict does.
inline constexpr const char* strict_help =
    "what is broken in the file, or not supported, is an error (status 3) instead of a warning";

/// Declares the options on `command`; parsing fills `options`.
void declare(CLI::App& command, RenderCommand& options);

/// Declares those that say what is rendered and by what, without those that say where it goes.
void declare_rendering(CLI::App& command, RenderCommand& options);

/// Declares --rig, --environment and what goes with it.
void declare_rig(CLI::App& command, scene::Rig& rig, EnvironmentArguments& environment);

/// Declares --error and --time; --samples is declared with what is rendered.
void declare_stopping(CLI::App& command, RenderCommand& options);

/// Declares exposure and tone curve.
void declare_display(CLI::App& command, RenderCommand& options);

} // namespace sr::cli
