#pragma once
// Differences in units of a known noise.
#include "golden/differences.hpp"

#include <cstddef>

namespace sr::golden {

/// The largest |z| that equal images exceed once in a thousand comparisons, at each of three scales, which
/// share that chance equally (Bonferroni): single values, sums over blocks, sums over the image.
struct NoiseLimits {
    double pixel = 0.0;
    double block = 0.0;
    double total = 0.0;
};

/// z-scores of a comparison. A block is 16×16 pixels; sums find what hides below the noise of one pixel.
struct NoiseScores {
    PixelValues pixels; // largest |z| over the colours
    double max_block = 0.0;
    double total = 0.0;
    NoiseLimits limits;
};

inline constexpr int noise_block = 16; // [pixels] edge of a block

/// Scores a pair against the standard errors in `noise`; their squares add up, and so does the rounding of a
/// float (1e-6 of the reference). Alpha is left out: its noise is not known.
/// @throws Error if a noise image is neither of the pair's size nor 1×1, or has a value that is negative or
/// not finite.
NoiseScores scored(const Pair& pair, const std::vector<image::Image>& noise);

/// The z that a standard normal variable exceeds in absolute value with the given chance.
double two_sided_z(double chance);

} // namespace sr::golden
