#pragma once
// Where red, green and blue are among an image's channels.
#include "image/image.hpp"

#include <array>

namespace sr::golden {

/// The indices of R, G and B by name (a reader may sort channels); of an unnamed image the first three, of a
/// grey one its only channel three times. The image has at least one channel.
std::array<std::size_t, 3> colour_channels(const image::Image& image);

} // namespace sr::golden
