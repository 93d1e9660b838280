#pragma once
// JPEG textures in memory, by libjpeg-turbo. Private to image/.
#include "image/file.hpp"

namespace sr::image {

/// Decodes a JPEG (grey, YCbCr, RGB, CMYK or YCCK) to opaque RGBA. Profiles and rotation are ignored, as
/// glTF 2.0 says (section 3.8.2). @throws Error in the file `name` if the data is broken, or of a kind that
/// JPEG libraries do not take
DecodedTexture decode_jpeg(std::span<const std::uint8_t> bytes, const std::string& name);

} // namespace sr::image
