#pragma once
// PNG in memory, by libspng. Other image formats go through OpenImageIO (codec.hpp), which takes much longer
// to load. Private to image/.
#include "image/file.hpp"

namespace sr::image {

/// Decodes a PNG to RGBA, values as stored: 16 bits a channel if the file has them, otherwise 8.
/// @throws Error in the file `name` if the data is broken
DecodedTexture decode_png(std::span<const std::uint8_t> bytes, const std::string& name);

/// Encodes up to four channels of values in 0..1 as 8 bits a channel, with the attributes as text. NaN
/// becomes 0.
/// @throws Error in the file `name` if the image has more than four channels
std::vector<std::uint8_t> encode_png(const Image& image, const std::string& name);

} // namespace sr::image
