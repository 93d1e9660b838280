#pragma once
// PNG, JPEG and WebP in memory: decoders of textures, and encoders of pictures. image/file.hpp chooses among
// them. Other formats go through OpenEXR (exr.hpp) or OpenImageIO (codec.hpp), which takes much longer to
// load.
#include "image/file.hpp"

namespace sr::image {

/// Decodes a PNG by libspng to RGBA, values as stored: 16 bits a channel if the file has them, otherwise 8.
/// @throws Error in the file `name` if the data is broken
DecodedTexture decode_png(std::span<const std::uint8_t> bytes, const std::string& name);

/// Encodes up to four channels of values in 0..1 as 8 bits a channel, with the attributes as text. NaN
/// becomes 0.
/// @throws Error in the file `name` if the image has more than four channels
std::vector<std::uint8_t> encode_png(const Image& image, const std::string& name);

/// Decodes a JPEG by libjpeg-turbo (grey, YCbCr, RGB, CMYK or YCCK) to opaque RGBA. Profiles and rotation are
/// ignored, as glTF 2.0 says (section 3.8.2). @throws Error in the file `name` if the data is broken, or of a
/// kind that JPEG libraries do not take
DecodedTexture decode_jpeg(std::span<const std::uint8_t> bytes, const std::string& name);

/// Encodes values in 0..1 as RGB (as_rgb()), with quality 95 and full chroma. NaN becomes 0.
/// @throws Error in the file `name` if a side is longer than JPEG allows
std::vector<std::uint8_t> encode_jpeg(const Image& image, const std::string& name);

/// Returns whether this build decodes WebP: whether libwebp was there when it was built.
bool decodes_webp();

/// Returns whether the file begins as a WebP does (RIFF).
bool is_webp(std::span<const std::uint8_t> bytes);

/// Counts the texels that its header claims; 0 if it is broken.
std::uint64_t webp_texels(std::span<const std::uint8_t> bytes);

/// Decodes the first (or only) picture as RGBA, as stored, by libwebp: OpenImageIO multiplies by alpha, which
/// loses what is stored. @throws Error in the file `name`: too large, or broken
DecodedTexture decode_webp(std::span<const std::uint8_t> bytes, const std::string& name);

} // namespace sr::image
