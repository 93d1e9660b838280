#pragma once
// The alpha that counts as opaque, and the texels that a texture coordinate reads: defined once, so that all
// users agree.
#include "scene/material.hpp"

#include <cmath>

namespace sr::scene {

/// The least alpha that alphaMode MASK shows. The cutoff itself is opaque (glTF 2.0, section 3.9.4), also
/// where an alpha that equals it was rounded: most where texels are half floats, by 2^-11 of the value. That
/// is less than an eighth of a step of 8 bits.
inline float min_opaque_alpha(const Material& material) {
    return material.alpha_cutoff * (1.0f - 1.0f / 2000.0f);
}

/// Returns the position of uv among the centres of width × height texels, in texels. Coordinates that are no
/// numbers, or so far out (2^24 texels) that the next float is a texel away, count as 0. Keep in sync with
/// shaders/base/texel_wrap.glsl.
inline vec2 texel_place(vec2 uv, int width, int height) {
    constexpr float farthest = 1.6e7f;
    const vec2 at = uv * vec2(width, height);
    const bool is_near = std::abs(at.x) < farthest && std::abs(at.y) < farthest;
    return (is_near ? at : vec2(0.0f)) - 0.5f;
}

} // namespace sr::scene
