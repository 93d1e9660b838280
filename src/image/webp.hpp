#pragma once
// WebP textures, decoded by libwebp itself: OpenImageIO multiplies by alpha, which loses what is stored.
#include "image/file.hpp"

namespace sr::image {

/// Returns whether this build decodes WebP: whether libwebp was there when it was built.
bool decodes_webp();

/// Returns whether the file begins as a WebP does (RIFF).
bool is_webp(std::span<const std::uint8_t> bytes);

/// Counts the texels that its header claims; 0 if it is broken.
std::uint64_t webp_texels(std::span<const std::uint8_t> bytes);

/// The first (or only) picture as RGBA, as stored. @throws Error in the file `name`: too large, or broken
DecodedTexture decode_webp(std::span<const std::uint8_t> bytes, const std::string& name);

} // namespace sr::image
