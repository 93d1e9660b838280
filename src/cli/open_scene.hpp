#pragma once
// Start of every command that renders: a context, and a scene prepared for a camera.
#include "cli/arguments.hpp"
#include "cli/summary.hpp"
#include "gltf/asset.hpp"
#include "render/renderer.hpp"

#include <memory>
#include <set>
#include <string>
#include <vector>

namespace sr::cli {

struct OpenScene {
    std::unique_ptr<gl::Context> context;
    scene::RenderScene stage;
    Size size;
    gltf::Asset asset; // what the scene was made of
    scene::PrepareOptions stage_options;
    std::vector<int> animations; // that play
    std::vector<int> frames;     // of --frames; empty: a single picture
    std::set<std::string> told;  // warnings that were printed
};

/// Reads the environment that --environment names; absent if it names none. Warnings go to stderr.
/// @throws Error
std::optional<scene::EnvironmentLight> environment_light(const RenderSettings& settings);

/// Opens a context and loads the scene at the same time, at the time of --at or of the first frame. Prints
/// warnings and remarks to stderr. @throws Error, also for a time or a frame beyond the animation
OpenScene open_scene(const RenderSettings& settings, PhaseTimes& times);

/// When a frame is [s].
double seconds_of(int frame, const RenderSettings& settings);

/// The scene at another of its frames.
void show_frame(OpenScene& open, const RenderSettings& settings, int frame);

/// The scene and its lights in the GPU's memory. @throws Error for what is beyond the driver's limits
render::GpuScene uploaded(const OpenScene& open, const RenderSettings& settings);

render::RenderOptions render_options(const RenderSettings& settings, Size size);

} // namespace sr::cli
