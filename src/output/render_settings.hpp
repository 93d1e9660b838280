#pragma once
// Settings that `steradian render` and the viewer share.
#include "image/display.hpp"
#include "render/adaptive/stop_rule.hpp"
#include "render/renderer.hpp"
#include "render/visibility/visibility_backend.hpp"
#include "scene/prepare.hpp"

#include <optional>
#include <string>
#include <vector>

namespace sr::output {

struct RenderSettings {
    std::string scene; // a file
    std::optional<int> scene_index;
    std::string camera; // as PrepareOptions has it
    scene::Rig rig = scene::Rig::automatic;
    bool hide_emitters = false;
    std::string animation;    // by name, by index, or "all"; empty: the first
    std::optional<double> at; // [s]; absent: the file's rest pose
    std::string variant;      // of KHR_materials_variants; empty: none
    bool is_strict = false;   // broken parts of the file are errors instead of remarks
    render::Visibility visibility = render::Visibility::ray;
    bool has_energy_compensation = false; // as GpuScene has it
    /// Seed, background, estimator and depth maps; size, shaders and samples follow from the rest.
    render::RenderOptions rendering;
    render::StopRule stop;
    std::vector<std::string> shaders; // folders that come before the built-in shaders
    bool is_untrusted = false;        // `shaders` pass the gate of glsl/untrusted.hpp
    std::optional<float> ev100;       // absent: automatic
    image::ToneCurve tone_curve = image::ToneCurve::neutral;
    bool gl_debug = false; // any error or warning of the driver is an error
};

} // namespace sr::output
