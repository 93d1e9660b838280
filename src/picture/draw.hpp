#pragma once
// A picture of an open scene: samples, layers, AOVs and the error, until a stop rule ends them.
#include "output/channels.hpp"
#include "picture/open_scene.hpp"
#include "settings/provenance.hpp"

#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace sr::picture {

/// The end of the sampling.
struct SamplingEnd {
    render::StoppedBy by = render::StoppedBy::samples;
    std::optional<double> error;                   // √relMSE; absent if the renderer does not know it
    std::optional<render::ErrorEstimate> estimate; // of the final samples
};

/// Result of a rendering.
struct Picture {
    image::Image film;                  // R, G, B, A
    std::optional<image::Image> layers; // the film and further channels
    settings::SampleCounts samples;
    SamplingEnd stop;
    int light_choices = 0; // of a sample; 0: it visits all lights
    std::optional<float>
        ev100{}; // of files for screens, automatic or that of the settings; absent: none was written
};

/// Hears of long work while it goes on: `what` is under way, `share` of it is done (0 to 1), `state` says so
/// in the work's own terms.
using Progress = std::function<void(const std::string& what, double share, const std::string& state)>;

/// Inputs of one picture.
struct Work {
    const RenderSettings& settings;
    const scene::RenderScene& stage;
    const render::GpuScene& scene;
    const render::RenderOptions& options; // of `renderer`
    render::Renderer& renderer;
    std::stop_token stop;
    Progress progress; // may be empty
    PhaseTimes& times;
    std::string what = "rendering";
};

/// Takes the samples, and renders further channels. After a stop it returns what is complete, with
/// StoppedBy::interruption. @throws Error
Picture draw(const Work& work);

/// Sets the provenance of the images.
void describe(Picture& picture, const RenderSettings& settings, const scene::RenderScene& stage,
              const gl::ContextInfo& gl);

} // namespace sr::picture
