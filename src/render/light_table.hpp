#pragma once
// The lights as the shaders read them.
#include "scene/light.hpp"

#include <span>
#include <vector>

namespace sr::render {

/// Five RGBA texels a light, the twin of shaders/interface/lights.glsl.
inline constexpr int texels_per_light = 5;
std::vector<vec4> pack_lights(std::span<const scene::Light> lights);

} // namespace sr::render
