#pragma once
// The lights as the shaders read them.
#include "render/gpu/light_texels.hpp"
#include "scene/scene.hpp"

#include <span>
#include <vector>

namespace sr::render {

/// Eight RGBA texels a light, behind them the light tree, then the corners, triangles, profiles and
/// descriptions of emission maps that they point to, and lists of the lights of each kind: the twin of
/// shaders/interface/lights.glsl. The last texel has the place of the tree, its number of nodes, and the
/// place of the lists. Textures and profiles are the scene's; the textures in use go to `maps`, the pictures
/// of environments to `environments`.
inline constexpr int texels_per_light = 8;
std::vector<vec4> pack_lights(const scene::Scene& scene, std::span<const scene::Light> lights,
                              EmissionMaps& maps, EnvironmentTexels& environments);

/// One entry of an alias table: of all that fall on entry i, the share `keep` stays and the rest goes to
/// `alias`.
struct AliasEntry {
    float keep = 1.0f;
    int alias = 0;
    float probability = 0.0f; // of i being chosen in all
};

/// Vose 1991's construction. Weights are finite and not negative; all zero: every entry is as likely.
std::vector<AliasEntry> alias_table(std::span<const double> weights);

} // namespace sr::render
