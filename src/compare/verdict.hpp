#pragma once
// Verdicts: tolerances applied to what was measured.
#include "compare/noise.hpp"

#include <optional>
#include <span>

namespace sr::compare {

/// One line of the result.
struct Verdict {
    bool passed = true;
    std::string line; // "rel ≤ 0.01 in 99.9 % of the pixels: in 97.8 %, largest 2.14"
};

/// Everything that a tolerance can limit.
struct Measurements {
    Metrics metrics;
    PixelValues abs;
    PixelValues rel;
    std::vector<double> floors;             // of relative errors, by colour
    std::vector<double> even_energy_ratios; // by colour, without pixels that an edge explains
    std::optional<NoiseScores> noise;
    Plane flip;     // empty if no pixel could be compared
    Plane hdr_flip; // empty for display-referred images
};

/// The compared pixels that an edge explains, of a tolerance that forgives them and passes.
std::vector<bool> pixels_at_edges(const AlignedImages& images, const Measurements& measurements,
                                  std::span<const Tolerance> tolerances);

/// The error of each compared pixel over its limit, the largest of all tolerances on pixels; 1 just passes.
/// A pixel that an edge explains has at most 1.
PixelValues errors_over_limits(const AlignedImages& images, const Measurements& measurements,
                               std::span<const Tolerance> tolerances);

/// Judges one tolerance.
/// @throws Error for z without known noise and for hdr_flip of display-referred images.
Verdict judge(const Tolerance& tolerance, const AlignedImages& images, const Measurements& measurements);

} // namespace sr::compare
