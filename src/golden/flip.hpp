#pragma once
// ꟻLIP: the difference that a person sees when two images alternate on a screen.
// Andersson, Nilsson, Akenine-Möller, Oskarsson, Åström, Fairchild 2020, "FLIP: A Difference Evaluator for
// Alternating Images" (LDR). Andersson, Nilsson, Shirley, Akenine-Möller 2021, "Visualizing and Communicating
// Errors in Rendered Images" (HDR).
#include "golden/compare.hpp"
#include "golden/planes.hpp"

namespace sr::golden {

/// The difference at each pixel, 0..1, of two images whose first three channels are linear RGB of a screen
/// (clamped to 0..1).
Plane flip(const image::Image& test, const image::Image& reference, float pixels_per_degree);

/// HDR-FLIP of two images of light: the largest FLIP over the exposures, each through the tone curve.
Plane hdr_flip(const image::Image& test, const image::Image& reference, const Exposures& exposures,
               float pixels_per_degree);

/// Exposures from what is lit in the reference (Andersson 2021, section 4, with the ACES curve): from where
/// the brightest lit pixel is near white to where their median is. Pixels that are black do not count, which
/// is where the paper's own rule fails; at most 16 stops.
Exposures exposures_for(const image::Image& reference);

/// The mean over all pixels.
double mean(const Plane& plane);

} // namespace sr::golden
