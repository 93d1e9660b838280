#pragma once
// Luminance of linear RGB with Rec. 709 primaries, in the unit of its argument.
#include "core/math.hpp"

namespace sr {

/// Y = 0.2126 R + 0.7152 G + 0.0722 B (ITU-R BT.709-6, item 3.2).
constexpr float luminance(float r, float g, float b) { return 0.2126f * r + 0.7152f * g + 0.0722f * b; }
inline float luminance(vec3 rgb) { return luminance(rgb.r, rgb.g, rgb.b); }
inline double luminance(glm::dvec3 rgb) { return 0.2126 * rgb.r + 0.7152 * rgb.g + 0.0722 * rgb.b; }

} // namespace sr
