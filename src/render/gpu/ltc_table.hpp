#pragma once
// GGX as linearly transformed cosines, and what lobes reflect, on the GPU for shaders/brdf/albedo_table.glsl.
#include "gl/object.hpp"

#include <span>

namespace sr::render {

/// Entries a side: rows of roughness, in each √cosθ_o.
inline constexpr int ltc_grid = 32;
/// Numbers an entry: a, b, c (scaled as tools/ltc/fit.cpp has it), ∫ D V cosθ, ∫ (1 - w·h)⁵ D V cosθ.
inline constexpr int ltc_numbers = 5;

/// assets/lut/ggx_ltc.inc: ltc_grid² entries of ltc_numbers.
std::span<const float> ltc_table();

/// A texture that is read linearly, from its lower left corner: ltc_grid² texels of a, b, c and the albedo;
/// above them ltc_grid² of Schlick's part, nothing, and the mean of 1 - albedo; above them 64² of the albedo
/// of sheen (assets/lut/charlie_albedo.inc).
gl::Texture upload_ltc_table();

} // namespace sr::render
