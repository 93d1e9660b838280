#pragma once
// Options of the viewer.
#include "glsl/root.hpp"
#include "image/display.hpp"
#include "render/adaptive/stop_rule.hpp"
#include "render/renderer.hpp"
#include "scene/prepare.hpp"

namespace sr::viewer {

struct Options {
    std::string scene; // a file
    std::optional<int> scene_index;
    std::string camera; // as PrepareOptions has it
    scene::Rig rig = scene::Rig::automatic;
    std::optional<scene::EnvironmentLight> environment; // as PrepareOptions has it
    bool hide_emitters = false;
    std::optional<double> at;  // [s]; absent: the file's rest pose
    std::string animation;     // as gltf::Asset::animations_named() takes it
    bool plays = false;        // from `at` or the beginning on
    std::string variant;       // of KHR_materials_variants; empty: none
    bool is_strict = false;    // broken parts of the file are errors instead of remarks
    bool is_reloading = false; // parts that the file has lost are remarks instead of errors
    render::Visibility visibility = render::Visibility::ray;
    bool has_energy_compensation = false; // as GpuScene has it
    /// Of the converging render. The viewer sets size, shader path and samples.
    render::RenderOptions rendering;
    render::StopRule stop;            // when the render has converged
    std::vector<std::string> shaders; // folders that come before the built-in shaders
    // Of an assignment.
    std::string submission;                 // a student's folder; empty if there is no assignment
    std::filesystem::path program;          // steradian, which checks the folder
    std::vector<glsl::Root> reference_path; // the reference's shaders
    bool shows_reference = false;           // renders with `reference_path` instead of `shaders`
    std::optional<float> ev100;             // absent for automatic exposure
    image::ToneCurve tone_curve = image::ToneCurve::neutral;
    int width = 0; // of the window [pixels]; 0: as last time, or 1280 × 720
    int height = 0;
    bool is_fullscreen = false;
    bool has_inertia = false; // a view that is released in motion glides on
    bool is_verbose = false;  // messages go to stderr, too
    bool gl_debug = false;    // any error or warning of the driver ends the viewer
};

} // namespace sr::viewer
