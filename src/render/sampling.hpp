#pragma once
// Low-discrepancy points, the C++ twin of shaders/base/sampling.glsl (a test holds the two equal).
#include "core/math.hpp"

#include <cstdint>

namespace sr::render {

/// Point `index` of the Owen-scrambled Sobol sequence that `seed` names, in [0, 1)².
vec2 sobol_2d(std::uint32_t index, std::uint32_t seed);

/// Where in its pixel sample `index` of `count` looks, in [0, 1)²: the box filter's points. A single sample
/// looks at the centre.
vec2 sub_pixel(int index, int count, std::uint32_t seed);

} // namespace sr::render
