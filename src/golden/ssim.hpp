#pragma once
// Wang, Bovik, Sheikh, Simoncelli 2004, "Image quality assessment: from error visibility to structural
// similarity".
#include "golden/planes.hpp"

namespace sr::golden {

/// The mean structural similarity of two planes whose values range over 0..1; 1 if they are equal. Means over
/// the windows that lie inside (11×11, Gaussian of σ = 1.5), or, if the image is smaller than that, over all.
double ssim(const Plane& test, const Plane& reference);

} // namespace sr::golden
