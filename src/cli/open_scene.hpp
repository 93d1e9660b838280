#pragma once
// Start of every command that renders: a context, and a scene prepared for a camera.
#include "cli/arguments.hpp"
#include "gltf/asset.hpp"
#include "render/renderer.hpp"

#include <chrono>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace sr::cli {

/// Seconds by phase, in the order in which they were measured.
class PhaseTimes {
public:
    /// Ends the phase that began when the last one ended (or when this object was made).
    void end(std::string phase);
    /// A phase that ran beside others and was measured elsewhere.
    void add(std::string phase, double seconds) { phases_.emplace_back(std::move(phase), seconds); }

    const std::vector<std::pair<std::string, double>>& phases() const { return phases_; }
    double total() const { return std::chrono::duration<double>(Clock::now() - begin_).count(); }

private:
    using Clock = std::chrono::steady_clock;

    Clock::time_point begin_ = Clock::now();
    Clock::time_point last_ = begin_;
    std::vector<std::pair<std::string, double>> phases_;
};

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
std::optional<scene::EnvironmentLight> read_environment_light(const RenderSettings& settings);

/// Opens a context and loads the scene at the same time, at the time of --at or of the first frame. Prints
/// warnings and remarks to stderr. @throws Error, also for a time or a frame beyond the animation
OpenScene open_scene(const RenderSettings& settings, PhaseTimes& times);

/// When a frame is [s].
double seconds_of(int frame, const RenderSettings& settings);

/// The scene at another of its frames.
void show_frame(OpenScene& open, const RenderSettings& settings, int frame);

/// The scene and its lights in the GPU's memory. @throws Error for what is beyond the driver's limits
render::GpuScene upload(const OpenScene& open, const RenderSettings& settings);

render::RenderOptions render_options(const RenderSettings& settings, Size size);

} // namespace sr::cli
