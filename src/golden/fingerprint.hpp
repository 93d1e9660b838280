#pragma once
// Whether two images are the same picture, whatever their files say beside it.
#include "image/image.hpp"

namespace sr::golden {

/// SHA-256 in hexadecimal of size, channel names and pixels. Not of the file: an EXR holds the time of its
/// writing.
std::string fingerprint(const image::Image& image);

} // namespace sr::golden
