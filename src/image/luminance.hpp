#pragma once
// Luminance of linear RGB with Rec. 709 primaries: the one place with its weights.
#include "core/math.hpp"

namespace sr::image {

/// Y = 0.2126 R + 0.7152 G + 0.0722 B (ITU-R BT.709-6, item 3.2), in the unit of its argument.
constexpr float luminance(float r, float g, float b) { return 0.2126f * r + 0.7152f * g + 0.0722f * b; }
inline float luminance(vec3 rgb) { return luminance(rgb.r, rgb.g, rgb.b); }

} // namespace sr::image
