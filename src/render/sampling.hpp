#pragma once
// Low-discrepancy points, the C++ twin of shaders/base/sampling.glsl (a test holds the two equal).
#include "core/math.hpp"

#include <array>
#include <cstdint>

namespace sr::render {

/// Point `index` of the Owen-scrambled Sobol sequence that `seed` names, in [0, 1)².
vec2 sobol_2d(std::uint32_t index, std::uint32_t seed);

/// Where in its pixel sample `index` of `count` looks, in [0, 1)²: the box filter's points. A single sample
/// looks at the centre.
vec2 sub_pixel(int index, int count, std::uint32_t seed);

/// The point of sample `index` in four dimensions more than those of sub_pixel(): two points of the same
/// sequence, in other orders, so that where samples look on a light is spread together with where they look
/// in the pixel. Digits to base 2, the first one lowest, which each pixel scrambles
/// (shaders/integrator/random_point.glsl).
std::array<std::uint32_t, 4> sample_digits(int index, std::uint32_t seed);

/// Two independent halves of one rendering, 0 and 1, take its samples by turns.
inline int half_of(int sample) { return sample % 2; }
/// Returns the number of samples that half `half` has of the first `count` ones.
inline int samples_of_half(int half, int count) { return (count + 1 - half) / 2; }
/// The seed of a half, from the rendering's own.
std::uint32_t half_seed(int half, std::uint32_t seed);

} // namespace sr::render
