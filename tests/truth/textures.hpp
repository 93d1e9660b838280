#pragma once
// Textures of the truth scenes.
#include "scene/scene.hpp"

namespace sr::truth {

/// Bright and dark squares of many colours, 8×8 texels. @return the texture's index
int add_pattern(scene::Scene& scene, scene::ColorSpace color_space, const scene::Sampler& sampler);

/// Gives the scene's first mesh texture coordinates, vertex colours and tangents, and its first material a
/// texture in every slot that reflects, under all wrap modes and a transform. Texels are several pixels wide:
/// mip levels, which Mitsuba does not have, are never read.
void add_textures(scene::Scene& scene);

/// Gives the scene's first mesh texture coordinates and tangents, and makes its first material a metal with
/// an sRGB-encoded base colour and a normal map, both enlarged.
void add_photograph(scene::Scene& scene);

/// Gives the first material a texture in every slot of glTF's layers and in those that they lie over.
void add_layer_textures(scene::Scene& scene);

} // namespace sr::truth
