#pragma once
// Further channels of an EXR: one layer per light, and AOVs.
#include "output/variables.hpp"
#include "render/renderer.hpp"

#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace sr::output {

/// A channel: "key.R", and its values from the upper left corner on.
struct ImageChannel {
    std::string name;
    std::vector<float> values;
};

/// Appends channels to `film` (R, G, B, A).
image::Image with_channels(const image::Image& film, const std::vector<ImageChannel>& channels);

/// Returns "emission", then a name for each light: its own, in letters, digits, '-' and '_', followed by a
/// number where that is taken or one of `reserved`; "light_3" for the nameless fourth.
std::vector<std::string> layer_names(std::span<const scene::Light> lights,
                                     const std::vector<std::string>& reserved = {});

/// Renders three channels for each of `names`, "name.R" and so on [the film's unit]: the picture without
/// lights, then the share of each light. Direct light is linear, so their sum is the film to float rounding.
/// `add_samples` takes all samples of a layer and returns false to stop.
/// @return nothing if it was stopped
std::vector<ImageChannel> render_layers(const std::vector<std::string>& names, render::Renderer& renderer,
                                        const std::function<bool(const std::string& layer)>& add_samples);

/// Input of the AOVs.
struct AovSource {
    const render::GpuScene& scene;
    const scene::Camera& camera;
    render::RenderOptions options; // the picture's own
    std::vector<int> samples;      // of each pixel
    std::optional<render::ErrorEstimate> error;
};

/// Renders the channels of `aovs`, in their order.
/// @return nothing if it was stopped
std::vector<ImageChannel> render_aovs(const Variables& aovs, const AovSource& source,
                                      const std::stop_token& stop);

/// Returns the names behind object and material indices, as JSON arrays: steradian:objects,
/// steradian:materials.
std::vector<image::Attribute> name_tables(const Variables& aovs, const scene::Scene& scene);

} // namespace sr::output
