#pragma once
// A picture in numbers, as `render --json` prints it, and remarks on it.
#include "picture/draw.hpp"

#include <nlohmann/json_fwd.hpp>

namespace sr::picture {

/// The summary of a rendering: settings, scene, driver, samples, error, shadows, programs, seconds by phase.
nlohmann::ordered_json summary_of(const Work& work, const gl::Context& context, const Picture& picture);

/// Writes remarks that explain a black picture and pixels that are not finite.
void remark_on(const image::Image& film, const RenderSettings& settings, const scene::RenderScene& stage);

/// Writes a remark where a picture has a greater error than the settings ask for.
void remark_on_error(const Picture& picture, const RenderSettings& settings);

} // namespace sr::picture
