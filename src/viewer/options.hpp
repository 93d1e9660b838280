#pragma once
// What the viewer is asked for.
#include "glsl/root.hpp"
#include "image/display.hpp"
#include "render/renderer.hpp"
#include "render/stop_rule.hpp"
#include "scene/prepare.hpp"

namespace sr::viewer {

struct Options {
    std::string scene; // a file
    std::optional<int> scene_index;
    std::string camera; // as StageOptions has it
    scene::Rig rig = scene::Rig::automatic;
    std::optional<scene::EnvironmentLight> environment; // as StageOptions has it
    bool hide_emitters = false;
    std::optional<double> at;  // [s]; absent: the file's rest pose
    std::string animation;     // as gltf::Asset::animations_named() takes it
    bool plays = false;        // the animation, from `at` or its beginning on
    std::string variant;       // of KHR_materials_variants; empty: none
    bool is_strict = false;    // what the file has broken is an error, and no remark
    bool is_reloading = false; // what the file no longer has is remarked on, and is no error
    render::Visibility visibility = render::Visibility::ray;
    bool has_energy_compensation = false; // as GpuScene has it
    /// Of the standing picture; size, shader path and samples are the viewer's own.
    render::RenderOptions rendering;
    render::StopRule stop;            // what the standing picture converges to
    std::vector<std::string> shaders; // folders, looked into before the built-in shaders
    // Of an assignment, whose marks are shown.
    std::string submission;                 // a student's folder; empty: none
    std::filesystem::path program;          // steradian, which checks it
    std::vector<glsl::Root> reference_path; // the reference's shaders
    bool shows_reference = false;           // instead of what `shaders` make
    std::optional<float> ev100;             // absent: automatic
    image::ToneCurve tone_curve = image::ToneCurve::neutral;
    int width = 0; // of the window [pixels]; 0: as it was last, or 1280 × 720
    int height = 0;
    bool is_fullscreen = false;
    bool has_inertia = false; // what is dragged goes on for a moment
    bool is_verbose = false;  // says on stderr what happens
    bool gl_debug = false;    // any error or warning of the driver ends the viewer
};

} // namespace sr::viewer
