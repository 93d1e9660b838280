// WebP textures: the very texels that went in, and one line for what is broken.
#include "core/error.hpp"
#include "image/file.hpp"
#include "support/address.hpp"

#include <vector>
#include <webp/encode.h>

using namespace sr;
using sr::testing::Test;

namespace {

using ByteVector = std::vector<std::uint8_t>;

const ByteVector texels{255, 128, 64, 128, 1, 2, 3, 255, 200, 100, 50,  1,
                        0,   0,   0,  255, 9, 8, 7, 6,   250, 251, 252, 253};

ByteVector lossless() {
    std::uint8_t* data = nullptr;
    const std::size_t size = WebPEncodeLosslessRGBA(texels.data(), 3, 2, 12, &data);
    ByteVector bytes(data, data + size);
    WebPFree(data);
    return bytes;
}

const Test exact("unit.image.webp.texels_are_as_stored", [] {
    const image::DecodedTexture texture = image::decode_texture(lossless(), "a.webp");
    EXPECT_EQ(texture.width, 3);
    EXPECT_EQ(texture.height, 2);
    EXPECT_EQ(std::get<ByteVector>(texture.texels), texels); // alpha multiplies nothing
});

const Test truncated_webp("unit.image.webp.what_is_cut_short_is_one_line", [] {
    const ByteVector whole = lossless();
    for (std::size_t size = 12; size + 1 < whole.size(); ++size) {
        try {
            image::decode_texture(std::span(whole).first(size), "a.webp");
            ADD_FAILURE() << size << " of " << whole.size() << " bytes are decoded";
        } catch (const Error& error) {
            EXPECT_STREQ(error.what(), "a.webp: a broken or truncated WebP: export it again");
        }
    }
});

} // namespace
