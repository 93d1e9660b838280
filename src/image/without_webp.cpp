// Built where libwebp is not found.
#include "core/error.hpp"
#include "image/texture_formats.hpp"

namespace sr::image {

bool decodes_webp() { return false; }

std::uint64_t webp_texels(std::span<const std::uint8_t>) { return 0; }

DecodedTexture decode_webp(std::span<const std::uint8_t>, const std::string& name) {
    throw Error({name}, "a WebP image, which this build does not decode",
                "build with libwebp-dev, or convert it to PNG or JPEG");
}

} // namespace sr::image
