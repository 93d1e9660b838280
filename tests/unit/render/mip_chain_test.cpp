#include "render/gpu/mip_chain.hpp"

#include "image/display.hpp"
#include "support/address.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/packing.hpp>
#include <iterator>

using namespace sr;
using namespace sr::render;
using sr::testing::Test;

namespace {

using scene::ColorSpace;

/// All channels of a texel have one value.
template<class Code = std::uint8_t>
scene::TextureImage grey(int width, int height, auto value_at) {
    std::vector<Code> texels;
    for (int i = 0; i < width * height; ++i)
        for (int c = 0; c < 4; ++c) texels.push_back(value_at(i % width, i / width));
    return {"grey", width, height, texels};
}

template<class T = std::uint8_t>
T value(const MipLevel& level, std::size_t index = 0) {
    return reinterpret_cast<const T*>(level.storage.get())[index];
}

float half_value(const MipLevel& level, std::size_t index = 0) {
    return glm::unpackHalf1x16(value<std::uint16_t>(level, index));
}

/// Level 0, put together from its bands, and the levels below it.
std::vector<MipLevel> chain_of(const TexelSource& source, ColorSpace color_space, TexelLayout layout) {
    const scene::TextureImage& image = source.image;
    std::vector<std::byte> texels;
    int rows_so_far = 0;
    for_each_band(source, layout, [&](int first_row, int rows, std::span<const std::byte> band) {
        EXPECT_EQ(first_row, rows_so_far) << "no row is missing";
        rows_so_far += rows;
        texels.insert(texels.end(), band.begin(), band.end());
    });
    EXPECT_EQ(rows_so_far, image.height);
    std::vector<MipLevel> levels;
    MipLevel& first = levels.emplace_back(MipLevel{image.width, image.height, texels.size(), {}});
    first.storage = std::make_unique<std::byte[]>(texels.size());
    std::ranges::copy(texels, first.storage.get());
    std::ranges::move(lower_mip_levels(source, color_space, layout), std::back_inserter(levels));
    return levels;
}

std::vector<MipLevel> chain(const scene::TextureImage& image, ColorSpace color_space, TexelNeeds needs = {}) {
    return chain_of(image, color_space, texel_layout(image, color_space, needs));
}

constexpr TexelNeeds exact{true, false};

const Test sizes("unit.render.mip_chain.sizes_halve_rounding_down", [] {
    const auto image = grey(13, 4, [](int, int) { return std::uint8_t{7}; });
    const auto levels = chain(image, ColorSpace::linear);
    ASSERT_EQ(levels.size(), 4u);
    EXPECT_EQ(levels[0].width, 13);
    EXPECT_EQ(levels[1].width, 6);
    EXPECT_EQ(levels[1].height, 2);
    EXPECT_EQ(levels[3].width, 1);
    EXPECT_EQ(levels[3].height, 1);
    for (const MipLevel& level : levels) {
        EXPECT_EQ(value(level), 7) << "a constant stays what it is";
        EXPECT_EQ(level.texels().size(), static_cast<std::size_t>(level.width) * level.height * 4);
    }
    for_each_band(image, {TexelFormat::unorm8}, [&](int, int, std::span<const std::byte> band) {
        EXPECT_EQ(band.data(), std::as_bytes(std::span(std::get<0>(image.texels))).data())
            << "level 0 is the image's own";
    });
});

// Black and white in equal parts are half the light: 128 as data, 188 as an sRGB colour; alpha is never a
// colour.
const Test light("unit.render.mip_chain.srgb_averages_light", [] {
    const auto checker =
        grey(2, 2, [](int x, int y) { return static_cast<std::uint8_t>((x + y) % 2 ? 255 : 0); });
    EXPECT_EQ(value(chain(checker, ColorSpace::linear)[1]), 128);
    const auto srgb = chain(checker, ColorSpace::srgb);
    EXPECT_EQ(value(srgb[1]), 188);
    EXPECT_EQ(value(srgb[1], 3), 128);
    EXPECT_EQ(half_value(chain(checker, ColorSpace::srgb, exact)[1]), 0.5f);
});

// A constant survives in both colour spaces for every value, on even and odd sizes.
const Test constants("unit.render.mip_chain.constants_survive", [] {
    for (int code = 0; code < 256; ++code) {
        for (const int size : {2, 3}) {
            const auto image = grey(size, size, [code](int, int) { return static_cast<std::uint8_t>(code); });
            EXPECT_EQ(value(chain(image, ColorSpace::srgb)[1]), code);
            EXPECT_EQ(value(chain(image, ColorSpace::linear)[1]), code);
            EXPECT_EQ(value<std::uint16_t>(chain(image, ColorSpace::linear, exact)[1]), 257 * code);
        }
    }
});

// Three columns become one: each counts a third.
const Test odd("unit.render.mip_chain.odd_sizes_weigh_by_area", [] {
    const auto image = grey(3, 1, [](int x, int) { return static_cast<std::uint8_t>(x == 2 ? 255 : 0); });
    EXPECT_EQ(value(chain(image, ColorSpace::linear)[1]), 85);
});

const Test words("unit.render.mip_chain.sixteen_bits_stay", [] {
    const auto image =
        grey<std::uint16_t>(2, 1, [](int x, int) { return static_cast<std::uint16_t>(1 + 2 * x); });
    EXPECT_EQ(value<std::uint16_t>(chain(image, ColorSpace::linear)[1]), 2);
});

// Half floats keep every sRGB code's light to 2^-11 of it, and 8-bit data stays what it is to the bit.
const Test exactness("unit.render.mip_chain.exact_formats_keep_every_code", [] {
    const auto ramp = grey(256, 1, [](int x, int) { return static_cast<std::uint8_t>(x); });
    EXPECT_EQ(texel_layout(ramp, ColorSpace::srgb, exact).format, TexelFormat::float16);
    EXPECT_EQ(texel_layout(ramp, ColorSpace::linear, exact).format, TexelFormat::unorm16);
    const auto colors = chain(ramp, ColorSpace::srgb, exact), data = chain(ramp, ColorSpace::linear, exact);
    for (std::size_t code = 0; code < 256; ++code) {
        const float stored = static_cast<float>(code) / 255.0f, linear = image::linear_of_srgb(stored);
        EXPECT_NEAR(half_value(colors[0], 4 * code), linear, linear / 2048.0f) << code;
        EXPECT_NEAR(half_value(colors[0], 4 * code + 3), stored, stored / 2048.0f) << code;
        EXPECT_EQ(static_cast<float>(value<std::uint16_t>(data[0], 4 * code)) / 65535.0f, stored) << code;
    }
});

// An image of many bands is stored as it is, whatever the sizes of its rows.
const Test bands("unit.render.mip_chain.bands_join", [] {
    for (const int width : {1, 3, 700, 20000}) {
        const auto image =
            grey(width, 100, [](int x, int y) { return static_cast<std::uint8_t>(x + 3 * y); });
        const auto stored = chain(image, ColorSpace::linear, exact);
        const auto& codes = std::get<std::vector<std::uint8_t>>(image.texels);
        ASSERT_EQ(stored[0].size, 2 * codes.size());
        for (std::size_t i = 0; i < codes.size(); i += 997)
            EXPECT_EQ(value<std::uint16_t>(stored[0], i), 257 * codes[i]) << width << " " << i;
    }
});

// A cutoff equal to a code's alpha must find it equal, and 16-bit sRGB keeps more than 8 bits on every
// driver.
const Test formats("unit.render.mip_chain.formats_follow_the_need", [] {
    const auto bytes = grey(1, 1, [](int, int) { return std::uint8_t{128}; });
    const auto words_of_color = grey<std::uint16_t>(1, 1, [](int, int) { return std::uint16_t{300}; });
    EXPECT_EQ(texel_layout(bytes, ColorSpace::srgb, {}).format, TexelFormat::srgb8);
    EXPECT_EQ(texel_layout(bytes, ColorSpace::linear, {}).format, TexelFormat::unorm8);
    EXPECT_EQ(texel_layout(words_of_color, ColorSpace::srgb, {}).format, TexelFormat::float16);
    EXPECT_EQ(texel_layout(words_of_color, ColorSpace::linear, {}).format, TexelFormat::unorm16);
    const auto compared = chain(bytes, ColorSpace::srgb, {true, true});
    EXPECT_EQ(value<float>(compared[0], 3), 128.0f / 255.0f);
    EXPECT_EQ(value<float>(compared[0], 0), image::linear_of_srgb(128.0f / 255.0f));
});

// One or two channels are stored alone, with the values that they have among four; three are too many.
const Test few_channels("unit.render.mip_chain.channels_that_nobody_reads_are_not_stored", [] {
    std::vector<std::uint8_t> texels;
    for (int i = 0; i < 4 * 6 * 5; ++i) texels.push_back(static_cast<std::uint8_t>(37 * i));
    const scene::TextureImage image{"data", 6, 5, texels};
    const auto all = chain(image, ColorSpace::linear, exact);
    for (const std::vector<std::size_t>& read : {std::vector<std::size_t>{0}, {3}, {1, 2}, {0, 3}}) {
        TexelNeeds needs{true, false, 0};
        for (const std::size_t c : read) needs.channels |= 1u << c;
        EXPECT_EQ(texel_layout(image, ColorSpace::linear, needs),
                  (TexelLayout{TexelFormat::unorm16, needs.channels}));
        const auto few = chain(image, ColorSpace::linear, needs);
        ASSERT_EQ(few.size(), all.size());
        for (std::size_t level = 0; level < all.size(); ++level) {
            ASSERT_EQ(4 * few[level].size, read.size() * all[level].size);
            for (std::size_t i = 0; i < all[level].size / 8; ++i)
                for (std::size_t c = 0; c < read.size(); ++c)
                    EXPECT_EQ(value<std::uint16_t>(few[level], read.size() * i + c),
                              value<std::uint16_t>(all[level], 4 * i + read[c]))
                        << level << " " << i;
        }
    }
    for (const unsigned read : {0u, 0b0111u, all_channels})
        EXPECT_EQ(texel_layout(image, ColorSpace::linear, {true, false, read}),
                  TexelLayout{TexelFormat::unorm16});
    EXPECT_EQ(texel_layout(image, ColorSpace::linear, {false, false, 1}), TexelLayout{TexelFormat::unorm8});
    EXPECT_EQ(texel_layout(image, ColorSpace::srgb, {true, false, 1}), TexelLayout{TexelFormat::float16});
});

// An alpha that comes from another image (TexturePacking) has its codes, where a half float of 0 to 1 would
// be off.
const Test exact_alpha("unit.render.mip_chain.a_packed_alpha_is_its_code", [] {
    const auto image = grey(16, 16, [](int x, int y) { return static_cast<std::uint8_t>(16 * y + x); });
    const TexelLayout layout{TexelFormat::float16_exact_alpha};
    for_each_band(image, layout, [&](int first_row, int rows, std::span<const std::byte> band) {
        const auto* texels = reinterpret_cast<const std::uint16_t*>(band.data());
        for (int i = 0; i < rows * image.width; ++i) {
            const float code = static_cast<float>(first_row * image.width + i);
            EXPECT_EQ(glm::unpackHalf1x16(texels[4 * i + 3]), code / 256.0f);
            EXPECT_EQ(texels[4 * i], glm::packHalf1x16(image::linear_of_srgb(code / 255.0f)));
        }
    });
    const auto levels = lower_mip_levels(image, ColorSpace::srgb, layout);
    EXPECT_EQ(half_value(levels[0], 3), 8.5f / 256.0f) << "the mean of 0, 1, 16 and 17";
});

// The alpha of another image stands in every level as if it were the image's own.
const Test other_alpha("unit.render.mip_chain.alpha_may_be_a_channel_of_another_image", [] {
    const auto noise = [](int seed) {
        std::vector<std::uint8_t> texels;
        for (int i = 0; i < 4 * 13 * 6; ++i)
            texels.push_back(static_cast<std::uint8_t>(i * (seed + i) % 251));
        return scene::TextureImage{"noise", 13, 6, texels};
    };
    const scene::TextureImage image = noise(3), other = noise(7);
    scene::TextureImage together = image;
    for (std::size_t i = 3; i < 4 * 13 * 6; i += 4)
        std::get<0>(together.texels)[i] = std::get<0>(other.texels)[i - 2];
    for (const TexelLayout layout : {TexelLayout{TexelFormat::unorm16}, {TexelFormat::float16_exact_alpha}}) {
        const ColorSpace color_space =
            layout.format == TexelFormat::unorm16 ? ColorSpace::linear : ColorSpace::srgb;
        const auto expected = chain_of(together, color_space, layout);
        const auto made = chain_of({image, other, 1}, color_space, layout);
        ASSERT_EQ(made.size(), mip_level_count(13, 6));
        for (std::size_t i = 0; i < made.size(); ++i)
            EXPECT_TRUE(std::ranges::equal(made[i].texels(), expected.at(i).texels())) << i;
    }
});

} // namespace
