#include "render/mip_chain.hpp"

#include "support/address.hpp"

using namespace sr;
using namespace sr::render;
using sr::testing::Test;

namespace {

scene::TextureImage grey(int width, int height, auto value_at) {
    std::vector<std::uint8_t> texels;
    for (int i = 0; i < width * height; ++i)
        for (int c = 0; c < 4; ++c) texels.push_back(value_at(i % width, i / width));
    return {"grey", width, height, texels};
}

std::uint8_t first_texel(const MipLevel& level, std::size_t channel = 0) {
    return std::get<std::vector<std::uint8_t>>(level.texels)[channel];
}

const Test sizes("unit.render.mip_chain.sizes_halve_rounding_down", [] {
    const auto levels =
        mip_chain(grey(13, 4, [](int, int) { return std::uint8_t{7}; }), scene::ColorSpace::linear);
    ASSERT_EQ(levels.size(), 3u);
    EXPECT_EQ(levels[0].width, 6);
    EXPECT_EQ(levels[0].height, 2);
    EXPECT_EQ(levels[2].width, 1);
    EXPECT_EQ(levels[2].height, 1);
    for (const MipLevel& level : levels) EXPECT_EQ(first_texel(level), 7) << "a constant stays what it is";
});

// Black and white in equal parts are half the light: 128 as data, 188 as an sRGB colour; alpha is never a
// colour.
const Test light("unit.render.mip_chain.srgb_averages_light", [] {
    const auto checker = [](int x, int y) { return static_cast<std::uint8_t>((x + y) % 2 ? 255 : 0); };
    EXPECT_EQ(first_texel(mip_chain(grey(2, 2, checker), scene::ColorSpace::linear)[0]), 128);
    const auto srgb = mip_chain(grey(2, 2, checker), scene::ColorSpace::srgb);
    EXPECT_EQ(first_texel(srgb[0]), 188);
    EXPECT_EQ(first_texel(srgb[0], 3), 128);
});

// A constant survives in both colour spaces for every value, on even and odd sizes.
const Test constants("unit.render.mip_chain.constants_survive", [] {
    for (int value = 0; value < 256; ++value) {
        for (const int size : {2, 3}) {
            const auto image =
                grey(size, size, [value](int, int) { return static_cast<std::uint8_t>(value); });
            EXPECT_EQ(first_texel(mip_chain(image, scene::ColorSpace::srgb)[0]), value);
            EXPECT_EQ(first_texel(mip_chain(image, scene::ColorSpace::linear)[0]), value);
        }
    }
});

// Three columns become one: each counts a third.
const Test odd("unit.render.mip_chain.odd_sizes_weigh_by_area", [] {
    const auto image = grey(3, 1, [](int x, int) { return static_cast<std::uint8_t>(x == 2 ? 255 : 0); });
    EXPECT_EQ(first_texel(mip_chain(image, scene::ColorSpace::linear)[0]), 85);
});

const Test words("unit.render.mip_chain.sixteen_bits_stay", [] {
    const scene::TextureImage image{"w", 2, 1, std::vector<std::uint16_t>{1, 1, 1, 1, 3, 3, 3, 3}};
    const auto levels = mip_chain(image, scene::ColorSpace::linear);
    EXPECT_EQ(std::get<std::vector<std::uint16_t>>(levels[0].texels)[0], 2);
});

} // namespace
