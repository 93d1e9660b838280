#pragma once
// The lights as the shaders read them.
#include "render/emission_maps.hpp"
#include "render/environment_texels.hpp"
#include "scene/scene.hpp"

#include <span>
#include <vector>

namespace sr::render {

/// Eight RGBA texels a light, behind them the corners, triangles, profiles and descriptions of emission maps
/// that they point to: the twin of shaders/interface/lights.glsl. Textures and profiles are the scene's; the
/// textures in use go to `maps`, the pictures of environments to `environments`.
inline constexpr int texels_per_light = 8;
std::vector<vec4> pack_lights(const scene::Scene& scene, std::span<const scene::Light> lights,
                              EmissionMaps& maps, EnvironmentTexels& environments);

} // namespace sr::render
