#pragma once
// Pictures of a comparison, for people. Three channels in 0..1, ready for a .png.
#include "compare/compare.hpp"

namespace sr::compare {

/// Each pixel's error over its limit in colours that grow brighter with it: black at 1/100 of the limit and
/// below, the middle at the limit, white at 100 times it; magenta where a pixel is not finite, dark blue-grey
/// where it is not compared.
image::Image heat_map(const Comparison& comparison);

/// Test, reference and heat map beside one another. Light is shown at the exposure of the reference.
image::Image side_by_side(const image::Image& test, const image::Image& reference,
                          const Comparison& comparison, const CompareOptions& options = {});

} // namespace sr::compare
