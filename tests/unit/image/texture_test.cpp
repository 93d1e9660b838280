#include "core/error.hpp"
#include "image/file.hpp"
#include "png_bytes.hpp"
#include "support/address.hpp"
#include "support/models.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <random>
#include <thread>

using namespace sr;
using namespace sr::image;
using sr::testing::ByteVector;
using sr::testing::Png;
using sr::testing::Test;

namespace {

ByteVector texels8(const Png& png) {
    const DecodedTexture texture = decode_texture(png.bytes(), "test.png");
    EXPECT_EQ(texture.width, static_cast<int>(png.width));
    EXPECT_EQ(texture.height, static_cast<int>(png.height));
    return std::get<ByteVector>(texture.texels);
}

std::string failure(std::span<const std::uint8_t> bytes) {
    try {
        decode_texture(bytes, "a.glb");
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

/// A JPEG of some detail, 64 x 48.
ByteVector jpeg() {
    const auto file = sr::testing::scratch_folder("texture_jpeg") / "a.jpg";
    Image picture(64, 48, 3);
    for (int i = 0; float& value : picture.pixels) value = static_cast<float>(i++ * 37 % 101) / 100.0f;
    write(picture, file, SampleType::integer8);
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

const Test grey("unit.image.texture.grey", [] {
    EXPECT_EQ(texels8({2, 1, 8, 0, {0, 10, 250}, {}, {}}), (ByteVector{10, 10, 10, 255, 250, 250, 250, 255}));
});

const Test one_bit_grey("unit.image.texture.one_bit_grey", [] {
    EXPECT_EQ(texels8({2, 1, 1, 0, {0, 0x40}, {}, {}}), (ByteVector{0, 0, 0, 255, 255, 255, 255, 255}));
});

const Test grey_alpha("unit.image.texture.grey_alpha", [] {
    EXPECT_EQ(texels8({1, 2, 8, 4, {0, 200, 0, 0, 100, 7}, {}, {}}),
              (ByteVector{200, 200, 200, 0, 100, 100, 100, 7}));
});

const Test rgb_rows_from_the_top("unit.image.texture.rgb_rows_from_the_top", [] {
    EXPECT_EQ(texels8({1, 2, 8, 2, {0, 1, 2, 3, 0, 4, 5, 6}, {}, {}}),
              (ByteVector{1, 2, 3, 255, 4, 5, 6, 255}));
});

const Test alpha_is_not_multiplied("unit.image.texture.alpha_is_not_multiplied", [] {
    EXPECT_EQ(texels8({2, 1, 8, 6, {0, 200, 100, 50, 0, 200, 100, 50, 128}, {}, {}}),
              (ByteVector{200, 100, 50, 0, 200, 100, 50, 128}));
});

const Test palette("unit.image.texture.palette", [] {
    EXPECT_EQ(texels8({2, 1, 8, 3, {0, 1, 0}, {9, 8, 7, 3, 2, 1}, {}}),
              (ByteVector{3, 2, 1, 255, 9, 8, 7, 255}));
    EXPECT_EQ(texels8({2, 1, 8, 3, {0, 1, 0}, {9, 8, 7, 3, 2, 1}, {40}}),
              (ByteVector{3, 2, 1, 255, 9, 8, 7, 40}));
});

const Test sixteen_bits("unit.image.texture.sixteen_bits", [] {
    const Png png{1, 1, 16, 2, {0, 0x12, 0x34, 0xFF, 0xFF, 0x00, 0x01}, {}, {}};
    const DecodedTexture texture = decode_texture(png.bytes(), "test.png");
    EXPECT_EQ(std::get<std::vector<std::uint16_t>>(texture.texels),
              (std::vector<std::uint16_t>{0x1234, 0xFFFF, 0x0001, 0xFFFF}));
});

const Test jpeg_is_decoded("unit.image.texture.jpeg_is_decoded", [] {
    const DecodedTexture texture = decode_texture(jpeg(), "test.jpg");
    const auto& texels = std::get<ByteVector>(texture.texels);
    ASSERT_EQ(texels.size(), 64u * 48u * 4u);
    EXPECT_NEAR(texels[0], 0, 12);
    EXPECT_NEAR(texels[1], 94, 12);  // 37 %
    EXPECT_NEAR(texels[2], 189, 12); // 74 %
    EXPECT_EQ(texels[3], 255);
});

const Test threads_decode_at_once("unit.image.texture.threads_decode_at_once", [] {
    const ByteVector bytes = jpeg();
    const auto expected = std::get<ByteVector>(decode_texture(bytes, "test.jpg").texels);
    std::vector<std::jthread> threads;
    for (int i = 0; i < 4; ++i)
        threads.emplace_back([&] {
            for (int k = 0; k < 20; ++k)
                EXPECT_EQ(std::get<ByteVector>(decode_texture(bytes, "test.jpg").texels), expected);
        });
});

const Test other_formats("unit.image.texture.other_formats", [] {
    EXPECT_EQ(failure({}), "a.glb: neither PNG nor JPEG, which is not supported: convert it to PNG or JPEG");
    const ByteVector ktx2{0xAB, 'K', 'T', 'X', ' ', '2', '0'};
    EXPECT_EQ(failure(ktx2), "a.glb: a KTX2 image, which is not supported: convert it to PNG or JPEG");
});

const Test size_is_checked_first("unit.image.texture.size_is_checked_first", [] {
    EXPECT_TRUE(failure(Png{16385, 1, 8, 0, {0}, {}, {}}.bytes())
                    .starts_with("a.glb: 16385 x 1 texels are too many"));
    EXPECT_TRUE(
        failure(Png{16384, 16384, 8, 0, {0}, {}, {}}.bytes()).starts_with("a.glb: 16384 x 16384 texels"));
    EXPECT_TRUE(
        failure(Png{0, 1, 8, 0, {0}, {}, {}}.bytes()).starts_with("a.glb: a broken or truncated PNG"));
    ByteVector large = jpeg();
    for (std::size_t i = 0; i + 8 < large.size(); ++i)
        if (large[i] == 0xFF && large[i + 1] == 0xC0) {
            std::fill_n(large.begin() + static_cast<std::ptrdiff_t>(i) + 5, 4, std::uint8_t{0xFF});
            break;
        }
    EXPECT_TRUE(failure(large).starts_with("a.glb: 65535 x 65535 texels are too many")) << failure(large);
});

const Test truncated("unit.image.texture.truncated", [] {
    const ByteVector whole_jpeg = jpeg();
    const ByteVector whole_png = Png{2, 2, 8, 0, {0, 1, 2, 0, 3, 4}, {}, {}}.bytes();
    for (const ByteVector& whole : {whole_jpeg, whole_png})
        for (std::size_t size = 0; size < whole.size() - 12; size += whole.size() / 40 + 1) {
            const std::string error = failure(std::span(whole).first(size));
            EXPECT_TRUE(error.starts_with("a.glb: ")) << size << " bytes gave " << error;
            EXPECT_EQ(error.find('\n'), std::string::npos);
        }
});

const Test mutated("unit.image.texture.mutated", [] {
    std::mt19937 random(2); // any seed: every outcome but a crash is fine
    const ByteVector originals[] = {jpeg(), Png{2, 2, 8, 6, ByteVector(18, 0), {}, {}}.bytes()};
    int failed = 0;
    for (int i = 0; i < 1000; ++i) {
        ByteVector bytes = originals[i % 2];
        for (int k = 0; k < 3; ++k) bytes[random() % bytes.size()] = static_cast<std::uint8_t>(random());
        if (failure(bytes) != "no error") ++failed;
    }
    EXPECT_GT(failed, 300) << "the mutations hardly reach the decoder";
});

} // namespace
