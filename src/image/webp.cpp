#include "image/texture_formats.hpp"

#include "core/error.hpp"
#include "image/header.hpp"

#include <webp/decode.h>

namespace sr::image {

bool decodes_webp() { return true; }

std::uint64_t webp_texels(std::span<const std::uint8_t> bytes) {
    WebPBitstreamFeatures features;
    if (WebPGetFeatures(bytes.data(), bytes.size(), &features) != VP8_STATUS_OK) return 0;
    return static_cast<std::uint64_t>(features.width) * static_cast<std::uint64_t>(features.height);
}

DecodedTexture decode_webp(std::span<const std::uint8_t> bytes, const std::string& name) {
    const auto fail = [&] { throw Error({name}, "a broken or truncated WebP", "export it again"); };
    WebPBitstreamFeatures features;
    if (WebPGetFeatures(bytes.data(), bytes.size(), &features) != VP8_STATUS_OK) fail();
    check_size(static_cast<std::uint32_t>(features.width), static_cast<std::uint32_t>(features.height), name);
    if (features.has_animation != 0)
        throw Error({name}, "an animated WebP, which is no texture", "export one picture");
    DecodedTexture texture{features.width, features.height, {}};
    auto& texels = texture.texels.emplace<std::vector<std::uint8_t>>(
        std::size_t{4} * static_cast<std::size_t>(features.width)
        * static_cast<std::size_t>(features.height));
    if (!WebPDecodeRGBAInto(bytes.data(), bytes.size(), texels.data(), texels.size(), 4 * features.width))
        fail();
    return texture;
}

} // namespace sr::image
