#pragma once
// One layer a light: direct light is linear, so a picture is the sum of the pictures under each light alone.
#include "render/renderer.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace sr::cli {

/// "emission", then a name for each light: its own, in letters, digits, '-' and '_', followed by a number
/// where that is taken; "light_3" for the nameless fourth.
std::vector<std::string> layer_names(std::span<const scene::Light> lights);

/// `film` (R, G, B, A) with three channels more for each of `names`, "name.R" and so on [the film's unit]:
/// what is left when no light shines, then what each light adds. Their sum is the film to float rounding.
/// Renders the picture anew for each layer by `add_samples`, which takes all samples and says whether it did.
/// @return absent if it did not
std::optional<image::Image> with_layers(const image::Image& film, const std::vector<std::string>& names,
                                        render::Renderer& renderer,
                                        const std::function<bool(const std::string& layer)>& add_samples);

} // namespace sr::cli
