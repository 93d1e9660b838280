#pragma once
// ꟻLIP: the difference that a person sees when two images alternate on a screen.
// Andersson, Nilsson, Akenine-Möller, Oskarsson, Åström, Fairchild 2020, "FLIP: A Difference Evaluator for
// Alternating Images" (LDR). Andersson, Nilsson, Shirley, Akenine-Möller 2021, "Visualizing and Communicating
// Errors in Rendered Images" (HDR).
#include "compare/options.hpp"
#include "compare/planes.hpp"

namespace sr::compare {

/// Compares two images whose first three channels are linear RGB of a screen (clamped to 0..1).
/// @return the difference at each pixel, 0..1
Plane flip(const image::Image& test, const image::Image& reference, float pixels_per_degree);

/// Compares two images of light: the largest FLIP over the exposures, each through the ACES curve.
Plane hdr_flip(const image::Image& test, const image::Image& reference, const Exposures& exposures,
               float pixels_per_degree);

/// Chooses exposures from the lit pixels of the reference (Andersson 2021, section 4, with the ACES curve):
/// from where the brightest is near white to where their median is; at most 16 stops. Black pixels do not
/// count: with them the paper's own rule fails.
Exposures exposures_for(const image::Image& reference);

} // namespace sr::compare
