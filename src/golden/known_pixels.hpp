#pragma once
// Pixels whose value is known in closed form.
#include "golden/suite.hpp"

namespace sr::golden {

/// The first pixel that is not what it is known to be, in a sentence with both values; empty if all are.
/// A pixel outside the image, or an image without colour, is wrong.
std::string wrong_known_pixels(const image::Image& image, std::span<const KnownPixel> pixels);

} // namespace sr::golden
