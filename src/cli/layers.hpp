#pragma once
// More than a film: further channels of an EXR, among them one layer a light. Direct light is linear, so a
// picture is the sum of the pictures under each light alone.
#include "render/renderer.hpp"

#include <functional>
#include <string>
#include <vector>

namespace sr::cli {

/// A channel: "key.R", and its values from the upper left corner on.
struct Plane {
    std::string name;
    std::vector<float> values;
};

/// `film` (R, G, B, A) with more channels.
image::Image with_planes(const image::Image& film, const std::vector<Plane>& planes);

/// Channel `channel` of an image.
std::vector<float> values_of(const image::Image& image, int channel);

/// "emission", then a name for each light: its own, in letters, digits, '-' and '_', followed by a number
/// where that is taken or one of `reserved`; "light_3" for the nameless fourth.
std::vector<std::string> layer_names(std::span<const scene::Light> lights,
                                     const std::vector<std::string>& reserved = {});

/// Three planes for each of `names`, "name.R" and so on [the film's unit]: what is left when no light shines,
/// then what each light adds. Their sum is the film to float rounding. Renders the picture anew for each
/// layer by `add_samples`, which takes all samples and says whether it did.
/// @return nothing if it did not
std::vector<Plane> light_layers(const std::vector<std::string>& names, render::Renderer& renderer,
                                const std::function<bool(const std::string& layer)>& add_samples);

} // namespace sr::cli
