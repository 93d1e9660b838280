#pragma once
// Tolerances applied: each pixel's error over its limit, and a verdict for each tolerance.
#include "golden/differences.hpp"
#include "golden/noise.hpp"
#include "golden/planes.hpp"

#include <optional>

namespace sr::golden {

/// Everything that limits are set on.
struct Measured {
    Metrics metrics;
    PixelValues abs;
    PixelValues rel;
    std::optional<NoiseScores> noise;
    Plane flip;     // empty if no pixel could be compared
    Plane hdr_flip; // empty for display-referred images
};

/// The error of each compared pixel over its limit, the largest of all tolerances that hold pixel by pixel;
/// 1 just passes.
PixelValues errors_over_limits(const Pair& pair, const Measured& measured,
                               std::span<const Tolerance> tolerances);

/// Whether the tolerance is kept, in one line with the numbers.
/// @throws Error for z without a noise floor and for hdr_flip of display-referred images.
Verdict judged(const Tolerance& tolerance, const Pair& pair, const Measured& measured);

} // namespace sr::golden
