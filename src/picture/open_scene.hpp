#pragma once
// Start of everything that renders a file: a context, and a scene prepared for a camera.
#include "gl/context.hpp"
#include "gltf/asset.hpp"
#include "settings/render_settings.hpp"

#include <chrono>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace sr::picture {

using settings::RenderSettings;
using settings::Size;

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

/// A camera that goes around a scene that stands still.
class Turn {
public:
    /// @param begin the camera of picture 0. @param bounds of the scene, around whose middle it goes
    Turn(scene::Camera begin, const scene::Bounds& bounds, const RenderSettings& settings);
    /// @param around the point that it goes around. @param fits_depths whether near and far are those of the
    /// scene as each picture sees it, and not the camera's
    Turn(scene::Camera begin, const scene::Bounds& bounds, vec3 around, int count, scene::TurnAxis axis,
         bool fits_depths);

    scene::Camera camera(int picture) const;

private:
    scene::Camera begin_;
    scene::Bounds bounds_;
    vec3 around_;
    int count_; // pictures of a whole turn
    scene::TurnAxis axis_;
    bool fits_depths_;
};

struct OpenScene {
    std::unique_ptr<gl::Context> context;
    scene::RenderScene stage;
    Size size;
    gltf::Asset asset; // what the scene was made of
    scene::PrepareOptions stage_options;
    std::vector<int> animations; // that play
    std::vector<int> frames;     // of --frames or --turntable; empty: a single picture
    std::set<std::string> told;  // warnings that were written
    std::optional<Turn> turn{};  // of --turntable
};

/// Returns the default size of a picture: 720 rows in the camera's aspect ratio, 16:9 if it has none.
Size picture_size(std::optional<float> aspect_ratio);

/// Returns the given folders in front of the built-in shaders; remarks on those that replace nothing.
/// @param is_untrusted whether they pass the gate of glsl/untrusted.hpp. @throws Error if one is no folder.
std::vector<glsl::Root> shader_path(const std::vector<std::string>& folders, bool is_untrusted = false);

/// Reads the environment that the settings name; absent if they name none. Remarks on what is wrong with it.
/// @throws Error, BadSetting
std::optional<scene::EnvironmentLight> read_environment_light(const RenderSettings& settings);

/// Opens a context and loads the scene at the same time, at the time of --at or of the first frame. Writes
/// warnings as remarks. @throws Error, also for a time or a frame beyond the animation; BadSetting
OpenScene open_scene(const RenderSettings& settings, PhaseTimes& times);

/// When a frame is [s].
double seconds_of(int frame, const RenderSettings& settings);

/// The scene at another of its frames, or its camera at another picture of the turn.
void show_frame(OpenScene& open, const RenderSettings& settings, int frame);

/// Frees the decoded images of a scene that is uploaded once and for all.
void free_images(OpenScene& open);

/// The scene and its lights in the GPU's memory. @throws Error for what is beyond the driver's limits
render::GpuScene upload(const OpenScene& open, const RenderSettings& settings);

/// Returns how the settings light and see a scene; without the extent of an animation.
scene::PrepareOptions prepare_options(const RenderSettings& settings,
                                      std::optional<scene::EnvironmentLight> environment);

/// Says which lights the analytic estimator cannot do without noise.
void remark_on_estimator(const RenderSettings& settings, const scene::RenderScene& stage);

render::RenderOptions render_options(const RenderSettings& settings, Size size);

} // namespace sr::picture
