#pragma once
// The feature half of FLIP: edges and points that one image has and the other lacks.
#include "golden/planes.hpp"

namespace sr::golden {

/// The feature difference at each pixel, 0..1, of two achromatic planes Y of YCxCz (Andersson 2020,
/// section 4.2).
Plane feature_difference(const Plane& test, const Plane& reference, float pixels_per_degree);

} // namespace sr::golden
