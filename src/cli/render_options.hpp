#pragma once
// The options of `steradian render`, one struct with the defaults.
#include "cli/arguments.hpp"
#include "cli/frame_names.hpp"
#include "cli/stopping.hpp"
#include "gl/context.hpp"
#include "image/display.hpp"
#include "image/file.hpp"
#include "output/render_settings.hpp"
#include "output/variables.hpp"
#include "render/renderer.hpp"
#include "render/visibility/visibility_backend.hpp"
#include "scene/prepare.hpp"

namespace CLI {
class App;
}

namespace sr::cli {

/// Values of --environment, --environment-rotation, --environment-strength and --hide-environment.
struct EnvironmentArguments {
    std::string source; // a file, or L, or R,G,B [cd/m²]; empty: none
    float degrees = 0.0f;
    float strength = 1.0f;
    bool is_hidden = false;

    /// Reads the file; warnings go to stderr. @throws Error
    std::optional<scene::EnvironmentLight> light() const;
};

struct RenderCommand : output::RenderSettings {
    std::vector<std::string> outputs; // one rendering, written in each form
    std::optional<Size> size;         // absent: 720 rows in the camera's aspect ratio, 16:9 if it has none
    std::optional<FrameRange> frames; // a sequence of pictures instead of one
    double fps = 24.0;
    EnvironmentArguments environment;
    bool light_layers = false;              // in .exr: a layer a light
    output::Variables aovs;                 // in .exr: further channels
    bool denoises = false;                  // the shadows of the analytic estimator
    const output::Variable* view = nullptr; // one term instead of radiance

    /// True if the picture estimates its error, for which it takes its samples from two sequences.
    bool asks_for_error() const;
    image::SampleType exr_type = image::SampleType::floating;
    gl::Backend backend = gl::Backend::automatic;
    bool json = false;
};

/// Help of --strict.
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
