#pragma once
// Takes the noise out of shadows: an edge-avoiding mean of V over the picture.
#include "image/image.hpp"

#include <vector>

namespace sr::render {

/// Values that distinguish surfaces, one of each kind per pixel.
struct Guides {
    image::Image normals;       // n in the first three channels, not necessarily unit
    std::vector<float> depths;  // along the camera's axis [m]
    std::vector<float> objects; // their numbers
};

/// `ratio`: V in R, G and B, and in A the variance of one of them; negative where there is no light to let
/// through, which takes no part. @return V filtered, A as it may be.
///
/// Five passes of 5×5 pixels, each twice as far apart (Dammertz et al. 2010, "Edge-avoiding À-Trous wavelet
/// transform"), weighted by normal, depth, object, and by how far values differ in units of their noise
/// (Schied et al. 2017, "Spatiotemporal variance-guided filtering", Eqs. 3 to 5): a pixel without noise keeps
/// its value to the bit.
image::Image filtered_ratio(image::Image ratio, const Guides& guides);

} // namespace sr::render
