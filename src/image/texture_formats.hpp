#pragma once
// Headers and decoders of textures in memory: PNG, JPEG and WebP. image/file.hpp chooses among them. Other
// formats go through OpenImageIO (codec.hpp), which takes much longer to load.
#include "image/file.hpp"

namespace sr::image {

inline constexpr std::uint32_t max_texture_size = 16384; // [texels] along an edge: what OpenGL drivers take
inline constexpr std::uint64_t max_texture_texels = 1ull << 26; // 256 MiB of 8-bit RGBA

enum class TextureFormat { png, jpeg };

/// Format and size of a texture, known before any decoder allocates memory.
struct Header {
    TextureFormat format = TextureFormat::png;
    std::uint32_t width = 0;
    std::uint32_t height = 0;
};

/// Returns the format and size of a PNG or JPEG, both within the limits above.
/// @throws Error in the file `name`: not a PNG or JPEG, no size in sight, too large, truncated.
Header read_header(std::span<const std::uint8_t> bytes, const std::string& name);

/// @throws Error in the file `name` if so many texels are too many
void check_size(std::uint32_t width, std::uint32_t height, const std::string& name);

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
