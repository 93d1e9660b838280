#pragma once
// Settings of a rendering: everything that a command line, a golden suite and the viewer choose.
#include "gl/context.hpp"
#include "image/display.hpp"
#include "image/file.hpp"
#include "output/variables.hpp"
#include "render/adaptive/convergence.hpp"
#include "render/renderer.hpp"
#include "render/visibility/visibility_backend.hpp"
#include "scene/prepare.hpp"
#include "settings/values.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace sr::settings {

inline constexpr std::array<NamedValue<scene::Rig>, 4> rigs{{{"auto", scene::Rig::automatic},
                                                             {"studio", scene::Rig::studio},
                                                             {"softboxes", scene::Rig::softboxes},
                                                             {"none", scene::Rig::none}}};
inline constexpr std::array<NamedValue<render::Estimator>, 2> estimators{
    {{"sampled", render::Estimator::sampled}, {"analytic", render::Estimator::analytic}}};
inline constexpr std::array<NamedValue<render::LightSampling>, 3> light_samplings{
    {{"auto", render::LightSampling::automatic},
     {"all", render::LightSampling::all},
     {"one", render::LightSampling::one}}};

inline constexpr std::array<NamedValue<scene::TurnAxis>, 4> turn_axes{{{"x", scene::TurnAxis::x},
                                                                       {"y", scene::TurnAxis::y},
                                                                       {"z", scene::TurnAxis::z},
                                                                       {"camera", scene::TurnAxis::camera}}};

/// Returns the options of a rendering before anyone chooses: its samples take one of the lights where there
/// are many.
inline render::RenderOptions default_rendering() {
    render::RenderOptions options;
    options.lights = render::LightSampling::automatic;
    return options;
}

/// Each member but the first two is a row of the table in options.cpp.
struct RenderSettings {
    std::string scene;                // a file
    std::vector<std::string> outputs; // files of `render`: one rendering, written in each form
    std::optional<int> scene_index;
    std::string camera;     // as PrepareOptions has it
    std::string variant;    // of KHR_materials_variants; empty: none
    bool is_strict = false; // broken parts of the file are errors instead of remarks
    bool hide_emitters = false;

    scene::Rig rig = scene::Rig::automatic;
    std::string environment;           // a file, or L, or R,G,B [cd/m²]; empty: none
    float environment_rotation = 0.0f; // around +Y [degrees]
    float environment_strength = 1.0f;
    bool hide_environment = false;

    std::optional<double> at; // [s]; absent: the file's rest pose
    std::string animation;    // by name, by index, or "all"; empty: the first
    std::optional<FrameRange> frames;
    double fps = 24.0;
    std::optional<int> turntable; // pictures from a camera that goes once around; `frames` are some of them
    scene::TurnAxis turn_axis = scene::TurnAxis::y; // that it goes around

    render::StopRule stop;
    /// Seed, background, estimator and depth maps; size, shaders and samples follow from the rest.
    render::RenderOptions rendering = default_rendering();
    bool has_energy_compensation = false; // as GpuScene has it
    render::Visibility visibility = render::Visibility::ray;
    bool denoises = false; // the shadows of the analytic estimator

    std::optional<Size> size;   // absent: 720 rows in the camera's aspect ratio, or the window's last size
    std::optional<float> ev100; // absent: automatic
    const image::ToneCurve* tone_curve = &image::default_tone_curve();
    image::SampleType exr_type = image::SampleType::floating;
    bool has_light_layers = false;          // in .exr: a layer for each light
    output::Variables aovs;                 // in .exr: further channels
    const output::Variable* view = nullptr; // one term instead of radiance

    gl::Backend backend = gl::Backend::automatic;
    std::vector<std::string> shaders; // folders that come before the built-in shaders
    bool is_untrusted = false;        // `shaders` pass the gate of glsl/untrusted.hpp
    bool gl_debug = false;            // any error or warning of the driver is an error

    /// Returns the channels of textures that shaders may read: those of other people read any.
    render::TextureChannels texture_channels() const {
        return shaders.empty() ? render::TextureChannels::in_use : render::TextureChannels::all;
    }

    /// Returns true if the picture estimates its error. It then takes its samples from two sequences.
    bool asks_for_error() const {
        return stop.asks_for_error() || denoises || output::holds(aovs, output::Finish::error);
    }
};

} // namespace sr::settings
