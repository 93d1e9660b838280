#pragma once
// The colour half of FLIP: filtered by the eye's contrast sensitivity, compared in a uniform space.
#include "golden/planes.hpp"
#include "image/image.hpp"

#include <array>

namespace sr::golden {

/// Three channels of one image: linear RGB, or YCxCz.
using Planes = std::array<Plane, 3>;

/// Linear RGB in 0..1 as YCxCz (Andersson 2020, section 4.1.1).
Planes ycxcz(const Planes& rgb);

/// The colour difference of two images in YCxCz at each pixel, 0..1 (Andersson 2020, section 4.1).
Plane color_difference(const Planes& test, const Planes& reference, float pixels_per_degree);

} // namespace sr::golden
