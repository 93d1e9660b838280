// Every kind of PNG and JPEG that glTF files bring: their values as stored, without gamma, profile or
// rotation.
#include "core/error.hpp"
#include "image/file.hpp"
#include "jpeg_bytes.hpp"
#include "png_bytes.hpp"
#include "support/address.hpp"

#include <algorithm>
#include <array>

using namespace sr;
using namespace sr::image;
using sr::testing::ByteVector;
using sr::testing::FlatJpeg;
using sr::testing::Png;
using sr::testing::Test;

namespace {

using Shorts = std::vector<std::uint16_t>;

template<class Value>
std::vector<Value> values_of(std::span<const std::uint8_t> bytes) {
    return std::get<std::vector<Value>>(decode_texture(bytes, "test").texels);
}

/// The first texel of a flat JPEG, all of which are alike.
std::array<int, 4> color_of(const FlatJpeg& jpeg) {
    const auto texels = values_of<std::uint8_t>(jpeg.bytes());
    EXPECT_EQ(texels.size(), 8u * 8u * 4u);
    for (std::size_t i = 4; i < texels.size(); ++i) EXPECT_EQ(texels[i], texels[i - 4]);
    return {texels[0], texels[1], texels[2], texels[3]};
}

using Color = std::array<int, 4>;

const Test low_depths("unit.image.texture.few_bits_fill_the_range", [] {
    const auto png = [](std::uint8_t depth, std::uint8_t type, std::uint8_t row) {
        return values_of<std::uint8_t>(
            Png{2, 1, depth, type, {0, row}, type == 3 ? ByteVector{9, 8, 7, 3, 2, 1} : ByteVector{}, {}}
                .bytes());
    };
    EXPECT_EQ(png(2, 0, 0b01'11'0000), (ByteVector{85, 85, 85, 255, 255, 255, 255, 255}));
    EXPECT_EQ(png(4, 0, 0x5F), (ByteVector{85, 85, 85, 255, 255, 255, 255, 255}));
    for (const auto& [depth, row] :
         {std::pair(1, 0b01000000), std::pair(2, 0b00'01'0000), std::pair(4, 0x01)})
        EXPECT_EQ(png(static_cast<std::uint8_t>(depth), 3, static_cast<std::uint8_t>(row)),
                  (ByteVector{9, 8, 7, 255, 3, 2, 1, 255}));
});

const Test deep("unit.image.texture.sixteen_bits_of_every_kind", [] {
    EXPECT_EQ(values_of<std::uint16_t>(Png{1, 1, 16, 0, {0, 0x12, 0x34}, {}, {}}.bytes()),
              (Shorts{0x1234, 0x1234, 0x1234, 0xFFFF}));
    EXPECT_EQ(values_of<std::uint16_t>(Png{1, 1, 16, 4, {0, 0x12, 0x34, 0x56, 0x78}, {}, {}}.bytes()),
              (Shorts{0x1234, 0x1234, 0x1234, 0x5678}));
    EXPECT_EQ(values_of<std::uint16_t>(Png{1, 1, 16, 6, {0, 1, 2, 3, 4, 5, 6, 0, 1}, {}, {}}.bytes()),
              (Shorts{0x0102, 0x0304, 0x0506, 0x0001}));
});

// The PNG specification, section 11.3.2: the one colour that tRNS names has alpha 0, all others are opaque.
const Test color_key("unit.image.texture.one_color_may_be_transparent", [] {
    EXPECT_EQ(values_of<std::uint8_t>(Png{2, 1, 8, 0, {0, 10, 250}, {}, {0, 250}}.bytes()),
              (ByteVector{10, 10, 10, 255, 250, 250, 250, 0}));
    EXPECT_EQ(values_of<std::uint8_t>(Png{2, 1, 8, 2, {0, 1, 2, 3, 4, 5, 6}, {}, {0, 1, 0, 2, 0, 3}}.bytes()),
              (ByteVector{1, 2, 3, 0, 4, 5, 6, 255}));
    EXPECT_EQ(
        values_of<std::uint16_t>(Png{1, 1, 16, 2, {0, 1, 2, 3, 4, 5, 6}, {}, {1, 2, 3, 4, 5, 6}}.bytes()),
        (Shorts{0x0102, 0x0304, 0x0506, 0}));
});

/// The rows of an 8×8 picture of grey x + 16 y in Adam7's passes.
ByteVector adam7_rows() {
    ByteVector rows;
    for (const auto& [x0, y0, dx, dy] : std::initializer_list<std::array<int, 4>>{{0, 0, 8, 8},
                                                                                  {4, 0, 8, 8},
                                                                                  {0, 4, 4, 8},
                                                                                  {2, 0, 4, 4},
                                                                                  {0, 2, 2, 4},
                                                                                  {1, 0, 2, 2},
                                                                                  {0, 1, 1, 2}})
        for (int y = y0; y < 8; y += dy) {
            rows.push_back(0);
            for (int x = x0; x < 8; x += dx) rows.push_back(static_cast<std::uint8_t>(x + 16 * y));
        }
    return rows;
}

const Test interlaced("unit.image.texture.interlaced", [] {
    Png png{8, 8, 8, 0, adam7_rows(), {}, {}};
    png.is_interlaced = true;
    const auto texels = values_of<std::uint8_t>(png.bytes());
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x)
            EXPECT_EQ(texels[static_cast<std::size_t>(4 * (8 * y + x))], x + 16 * y) << x << " " << y;
});

/// An ICC profile without a tag, which says nothing but that it is one.
ByteVector profile() {
    ByteVector icc(132, 0);
    const auto put = [&](std::size_t at, std::string_view text) {
        std::ranges::copy(text, icc.begin() + static_cast<std::ptrdiff_t>(at));
    };
    icc[3] = 132;
    icc[8] = 2;
    put(12, "mntrRGB XYZ ");
    put(36, "acsp");
    put(68, std::string_view("\0\0\xF6\xD6\0\1\0\0\0\0\xD3\x2D", 12)); // D50
    return icc;
}

// glTF 2.0, section 3.8.2: colour space information of images is ignored.
const Test color_spaces("unit.image.texture.gamma_and_profiles_change_nothing", [] {
    const ByteVector linear{0, 1, 0x86, 0xA0}, steep{0, 0, 0x4E, 0x20};
    const ByteVector primaries(32, 1);
    for (const auto& [type, data] : std::vector<std::pair<std::string, ByteVector>>{
             {"gAMA", linear},
             {"gAMA", steep},
             {"sRGB", {0}},
             {"cHRM", primaries},
             {"iCCP", profile()},
             {"sBIT", {5, 6, 5}},
             {"bKGD", {0, 1, 0, 2, 0, 3}},
             {"tIME", {7, 230, 1, 1, 1, 1, 1}},
             {"eXIf",
              {'M', 'M', 0, '*', 0, 0, 0, 8, 0, 1, 1, 0x12, 0, 3, 0, 0, 0, 1, 0, 6, 0, 0, 0, 0, 0, 0}}}) {
        Png png{2, 1, 8, 2, {0, 10, 20, 30, 100, 200, 250}, {}, {}};
        png.chunks.emplace_back(type, data);
        EXPECT_EQ(values_of<std::uint8_t>(png.bytes()), (ByteVector{10, 20, 30, 255, 100, 200, 250, 255}))
            << type;
        Png deep_png{1, 1, 16, 0, {0, 0x12, 0x34}, {}, {}};
        if (type == "gAMA") {
            deep_png.chunks.emplace_back(type, data);
            EXPECT_EQ(values_of<std::uint16_t>(deep_png.bytes())[0], 0x1234);
        }
    }
});

// ITU-T T.871: R = Y + 1.402 (Cr - 128) and so on. CMYK of Adobe is stored inverted.
const Test jpegs("unit.image.texture.jpeg_of_every_kind", [] {
    for (const bool is_progressive : {false, true}) {
        EXPECT_EQ(color_of({{77}, is_progressive, {}, {}}), (Color{77, 77, 77, 255}));
        EXPECT_EQ(color_of({{100, 128, 128}, is_progressive, {}, {}}), (Color{100, 100, 100, 255}));
        EXPECT_EQ(color_of({{76, 85, 255}, is_progressive, {}, {}}), (Color{254, 0, 0, 255}));
        EXPECT_EQ(color_of({{10, 130, 250}, is_progressive, std::uint8_t{0}, {}}), (Color{10, 130, 250, 255}))
            << "RGB";
        EXPECT_EQ(color_of({{200, 100, 50, 255}, is_progressive, std::uint8_t{0}, {}}),
                  (Color{200, 100, 50, 255}))
            << "CMYK";
        EXPECT_EQ(color_of({{255, 255, 255, 0}, is_progressive, std::uint8_t{0}, {}}), (Color{0, 0, 0, 255}));
        EXPECT_EQ(color_of({{100, 128, 128, 255}, is_progressive, std::uint8_t{2}, {}}),
                  (Color{155, 155, 155, 255}))
            << "YCCK";
        EXPECT_EQ(color_of({{100, 128, 128}, is_progressive, {}, std::uint8_t{6}}),
                  (Color{100, 100, 100, 255}))
            << "turned";
    }
    FlatJpeg lossless{{77}, false, {}, {}};
    lossless.frame = 0xC3;
    try {
        decode_texture(lossless.bytes(), "a.jpg");
        ADD_FAILURE() << "no error";
    } catch (const Error& error) {
        EXPECT_TRUE(std::string(error.what()).starts_with("a.jpg: cannot be decoded (")) << error.what();
    }
});

} // namespace
