#include "render/gpu/mip_chain.hpp"

#include "core/error.hpp"
#include "image/display.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <glm/gtc/packing.hpp>
#include <limits>

namespace sr::render {
namespace {

using std::uint16_t;
using std::uint32_t;
using std::uint8_t;

template<class Code>
constexpr float max_code = static_cast<float>(std::numeric_limits<Code>::max());

// A codec turns an image's codes into stored values, and these into values that can be averaged, and back.
// Channel 3 is alpha, which is linear everywhere. It also says how many channels a
// texel stores.

struct Unorm8 {
    static constexpr int channels = 4;
    using Stored = uint8_t;
    using Sum = uint32_t; // of values of 16 bits
    static Stored store(uint8_t code, int) { return code; }
    static Sum decode(Stored v, int) { return v * 257u; }
    static Stored encode(Sum v, int) { return static_cast<Stored>((v + 128u) / 257u); }
};

template<int count>
struct Unorm16 {
    static constexpr int channels = count;
    using Stored = uint16_t;
    using Sum = uint32_t;
    static Stored store(uint8_t code, int) { return static_cast<Stored>(code * 257u); }
    static Stored store(uint16_t code, int) { return code; }
    static Sum decode(Stored v, int) { return v; }
    static Stored encode(Sum v, int) { return static_cast<Stored>(v); }
};

/// sRGB: IEC 61966-2-1.
struct Srgb8 {
    static constexpr int channels = 4;
    using Stored = uint8_t;
    using Sum = uint32_t;
    static const std::array<uint16_t, 256>& to_linear() {
        static const auto table = [] {
            std::array<uint16_t, 256> linear{};
            for (std::size_t i = 0; i < linear.size(); ++i)
                linear[i] = static_cast<uint16_t>(
                    std::lround(image::linear_of_srgb(static_cast<float>(i) / 255.0f) * 65535.0f));
            return linear;
        }();
        return table;
    }
    static const std::vector<uint8_t>& to_srgb() {
        static const auto table = [] {
            std::vector<uint8_t> codes(65536);
            for (std::size_t i = 0; i < codes.size(); ++i)
                codes[i] = static_cast<uint8_t>(
                    std::lround(image::srgb_of_linear(static_cast<float>(i) / 65535.0f) * 255.0f));
            return codes;
        }();
        return table;
    }
    static Stored store(uint8_t code, int) { return code; }
    static Sum decode(Stored v, int channel) { return channel == 3 ? Unorm8::decode(v, 3) : to_linear()[v]; }
    static Stored encode(Sum v, int channel) { return channel == 3 ? Unorm8::encode(v, 3) : to_srgb()[v]; }
};

/// The light that a code of an sRGB image stands for.
template<class Code>
float linear_value(Code code, int channel) {
    const float stored = static_cast<float>(code) / max_code<Code>;
    return channel == 3 ? stored : image::linear_of_srgb(stored);
}

struct Float16 {
    static constexpr int channels = 4;
    using Stored = uint16_t;
    using Sum = float;
    static const std::vector<float>& to_float() {
        static const auto table = [] {
            std::vector<float> values(65536);
            for (std::size_t i = 0; i < values.size(); ++i)
                values[i] = glm::unpackHalf1x16(static_cast<uint16_t>(i));
            return values;
        }();
        return table;
    }
    template<class Code>
    static Stored store(Code code, int channel) {
        return glm::packHalf1x16(linear_value(code, channel));
    }
    static Sum decode(Stored v, int) { return to_float()[v]; }
    static Stored encode(Sum v, int) { return glm::packHalf1x16(v); }
};

struct Float16ExactAlpha : Float16 {
    template<class Code>
    static Stored store(Code code, int channel) {
        return channel == 3 ? glm::packHalf1x16(static_cast<float>(code) / 256.0f)
                            : Float16::store(code, channel);
    }
};

struct Float32 {
    static constexpr int channels = 4;
    using Stored = float;
    using Sum = float;
    template<class Code>
    static Stored store(Code code, int channel) {
        return linear_value(code, channel);
    }
    static Sum decode(Stored v, int) { return v; }
    static Stored encode(Sum v, int) { return v; }
};

uint32_t quarter(uint32_t sum) { return (sum + 2u) / 4u; }
float quarter(float sum) { return 0.25f * sum; }

template<class Sum>
Sum rounded_to(float value) {
    if constexpr (std::is_same_v<Sum, float>)
        return value;
    else
        return static_cast<Sum>(std::min(value + 0.5f, 65535.0f));
}

/// The source texels that texel `x` of `half` covers of a row of `full`, and how much of each: weights sum
/// to 1.
struct Taps {
    int first = 0;
    int count = 0;
    std::array<float, 3> weights{};
};

Taps taps_of(int x, int half, int full) {
    const double scale = static_cast<double>(full) / half;
    const double begin = x * scale, end = (x + 1) * scale;
    Taps taps;
    taps.first = static_cast<int>(begin);
    taps.count = std::min(3, static_cast<int>(std::ceil(end - 1e-9)) - taps.first);
    for (int i = 0; i < taps.count; ++i) {
        const double covered = std::min(end, taps.first + i + 1.0) - std::max(begin, taps.first + i + 0.0);
        taps.weights[static_cast<std::size_t>(i)] = static_cast<float>(covered / scale);
    }
    return taps;
}

/// Values that the codes of an image become: those of colours, then those of alpha.
template<class Code, class Value>
class CodeTable {
public:
    explicit CodeTable(Value (*of)(Code, int channel)) {
        for (const int channel : {0, 3})
            for (std::size_t code = 0; code < codes; ++code)
                values_.push_back(of(static_cast<Code>(code), channel));
    }
    /// Those of a channel, by code.
    const Value* of_channel(int channel) const { return &values_[channel == 3 ? codes : 0]; }

private:
    static constexpr std::size_t codes = std::size_t{std::numeric_limits<Code>::max()} + 1;
    std::vector<Value> values_;
};

template<class Codec, class Code>
const CodeTable<Code, typename Codec::Stored>& stored_of_code() {
    static const CodeTable<Code, typename Codec::Stored> table(
        [](Code code, int channel) -> typename Codec::Stored { return Codec::store(code, channel); });
    return table;
}

template<class Codec, class Code>
const CodeTable<Code, typename Codec::Sum>& sum_of_code() {
    static const CodeTable<Code, typename Codec::Sum> table(
        [](Code code, int channel) -> typename Codec::Sum {
            return Codec::decode(stored_of_code<Codec, Code>().of_channel(channel)[code], channel);
        });
    return table;
}

/// A channel of an image, and what its codes become.
template<class Code, class Value>
struct Plane {
    const Code* codes;
    const Value* values;
    Value operator()(std::ptrdiff_t texel) const { return values[codes[4 * texel]]; }
};

template<class Codec, class Code, class Value>
using Planes = std::array<Plane<Code, Value>, Codec::channels>;

/// The channels that a texel stores, in their order.
template<class Codec, class Code, class Value>
Planes<Codec, Code, Value> planes_of(const TexelSource& source, unsigned channels,
                                     const CodeTable<Code, Value>& table) {
    const auto first = [](const scene::TextureImage& image, int channel) {
        return std::get<std::vector<Code>>(image.texels).data() + channel;
    };
    Planes<Codec, Code, Value> planes{};
    std::size_t count = 0;
    for (int c = 0; c < 4 && count < planes.size(); ++c) {
        if (!(channels >> c & 1u)) continue;
        const bool is_elsewhere = c == 3 && source.alpha_from;
        planes[count++] = {is_elsewhere ? first(*source.alpha_from, source.alpha_channel)
                                        : first(source.image, c),
                           table.of_channel(c)};
    }
    return planes;
}

// A source gives values that can be averaged, whether they are read from an image or from a level.

/// Level 0, without storing it.
template<class Codec, class Code>
struct ImageSource {
    Planes<Codec, Code, typename Codec::Sum> planes;
    typename Codec::Sum operator()(std::ptrdiff_t texel, int channel) const {
        return planes[static_cast<std::size_t>(channel)](texel);
    }
};

template<class Codec>
struct LevelSource {
    const typename Codec::Stored* values;
    typename Codec::Sum operator()(std::ptrdiff_t texel, int channel) const {
        return Codec::decode(values[Codec::channels * texel + channel], channel);
    }
};

/// Both sizes even, or 1: four texels of equal weight.
template<class Codec>
void halve_evenly(const auto& source, int width, int height, typename Codec::Stored* to) {
    const std::ptrdiff_t right = width > 1 ? 1 : 0, below = height > 1 ? width : 0;
    for (std::ptrdiff_t y = 0; y < std::max(1, height / 2); ++y) {
        std::ptrdiff_t texel = 2 * y * below;
        for (int x = 0; x < std::max(1, width / 2); ++x, texel += 2 * right) {
            for (int c = 0; c < Codec::channels; ++c) {
                const auto sum = source(texel, c) + source(texel + right, c) + source(texel + below, c)
                                 + source(texel + right + below, c);
                *to++ = Codec::encode(quarter(sum), c);
            }
        }
    }
}

template<class Codec>
void halve_by_area(const auto& source, int width, int height, typename Codec::Stored* to) {
    const int half_width = std::max(1, width / 2), half_height = std::max(1, height / 2);
    std::vector<Taps> columns;
    for (int x = 0; x < half_width; ++x) columns.push_back(taps_of(x, half_width, width));
    for (int y = 0; y < half_height; ++y) {
        const Taps rows = taps_of(y, half_height, height);
        for (const Taps& taps : columns) {
            for (int c = 0; c < Codec::channels; ++c) {
                float sum = 0.0f;
                for (int j = 0; j < rows.count; ++j)
                    for (int i = 0; i < taps.count; ++i) {
                        const auto texel =
                            static_cast<std::ptrdiff_t>(rows.first + j) * width + taps.first + i;
                        sum += rows.weights[static_cast<std::size_t>(j)]
                               * taps.weights[static_cast<std::size_t>(i)]
                               * static_cast<float>(source(texel, c));
                    }
                *to++ = Codec::encode(rounded_to<typename Codec::Sum>(sum), c);
            }
        }
    }
}

template<class Codec>
MipLevel half_of(const auto& source, int width, int height) {
    MipLevel half{std::max(1, width / 2), std::max(1, height / 2), 0, {}};
    half.size =
        static_cast<std::size_t>(half.width) * half.height * Codec::channels * sizeof(typename Codec::Stored);
    half.storage = std::make_unique_for_overwrite<std::byte[]>(half.size);
    auto* to = reinterpret_cast<typename Codec::Stored*>(half.storage.get());
    const bool is_even = (width % 2 == 0 || width == 1) && (height % 2 == 0 || height == 1);
    if (is_even)
        halve_evenly<Codec>(source, width, height, to);
    else
        halve_by_area<Codec>(source, width, height, to);
    return half;
}

template<class Codec, class Code>
std::vector<MipLevel> levels_below(const TexelSource& source, unsigned channels) {
    std::vector<MipLevel> levels;
    const scene::TextureImage& image = source.image;
    if (image.width == 1 && image.height == 1) return levels;
    const ImageSource<Codec, Code> level_0{planes_of<Codec>(source, channels, sum_of_code<Codec, Code>())};
    levels.push_back(half_of<Codec>(level_0, image.width, image.height));
    while (levels.back().width > 1 || levels.back().height > 1) {
        const MipLevel& last = levels.back();
        const auto* values = reinterpret_cast<const typename Codec::Stored*>(last.storage.get());
        levels.push_back(half_of<Codec>(LevelSource<Codec>{values}, last.width, last.height));
    }
    return levels;
}

/// Calls work<Codec, Code>() with the types of the layout and of the image.
auto with_types(const scene::TextureImage& image, TexelLayout layout, const auto& work) {
    const bool is_8_bit = std::holds_alternative<std::vector<uint8_t>>(image.texels);
    const auto with_code = [&]<class Codec> {
        return is_8_bit ? work.template operator()<Codec, uint8_t>()
                        : work.template operator()<Codec, uint16_t>();
    };
    require(is_8_bit || (layout.format != TexelFormat::unorm8 && layout.format != TexelFormat::srgb8),
            "8 bits hold an image of 8 bits");
    switch (layout.format) {
    case TexelFormat::unorm8: return work.template operator()<Unorm8, uint8_t>();
    case TexelFormat::srgb8: return work.template operator()<Srgb8, uint8_t>();
    case TexelFormat::unorm16:
        switch (std::popcount(layout.channels)) {
        case 1: return with_code.template operator()<Unorm16<1>>();
        case 2: return with_code.template operator()<Unorm16<2>>();
        default: return with_code.template operator()<Unorm16<4>>();
        }
    case TexelFormat::float16: return with_code.template operator()<Float16>();
    case TexelFormat::float16_exact_alpha: return with_code.template operator()<Float16ExactAlpha>();
    case TexelFormat::float32: break;
    }
    return with_code.template operator()<Float32>();
}

using Take = std::function<void(int first_row, int rows, std::span<const std::byte>)>;

template<class Codec, class Code>
void convert_bands(const TexelSource& source, unsigned channels, const Take& take) {
    using Stored = typename Codec::Stored;
    constexpr std::size_t band_values = std::size_t{64} << 10; // fit into a core's cache
    const scene::TextureImage& image = source.image;
    const auto planes = planes_of<Codec>(source, channels, stored_of_code<Codec, Code>());
    const std::size_t row_values = std::size_t{Codec::channels} * image.width;
    const int max_rows = static_cast<int>(std::max<std::size_t>(1, band_values / row_values));
    std::vector<Stored> band;
    for (int row = 0; row < image.height; row += max_rows) {
        const int rows = std::min(max_rows, image.height - row);
        band.resize(rows * row_values);
        std::ptrdiff_t texel = std::ptrdiff_t{row} * image.width;
        for (auto to = band.begin(); to != band.end(); ++texel)
            for (const auto& plane : planes) *to++ = plane(texel);
        take(row, rows, std::as_bytes(std::span(band)));
    }
}

} // namespace

TexelSource::TexelSource(const scene::TextureImage& image_) : image(image_) {}

TexelSource::TexelSource(const scene::TextureImage& image_, const scene::TextureImage& alpha_from_,
                         int alpha_channel_)
    : image(image_), alpha_from(&alpha_from_), alpha_channel(alpha_channel_) {
    const auto has_8_bits = [](const scene::TextureImage& any) {
        return std::holds_alternative<std::vector<uint8_t>>(any.texels);
    };
    require(has_8_bits(image) && has_8_bits(*alpha_from) && image.width == alpha_from->width
                && image.height == alpha_from->height,
            "images that are packed are alike");
}

TexelLayout texel_layout(const scene::TextureImage& image, scene::ColorSpace color_space, TexelNeeds needs) {
    const bool is_8_bit = std::holds_alternative<std::vector<uint8_t>>(image.texels);
    const bool is_srgb = color_space == scene::ColorSpace::srgb;
    if (is_8_bit && !needs.driver_is_inexact) return {is_srgb ? TexelFormat::srgb8 : TexelFormat::unorm8};
    if (is_srgb) return {needs.alpha_is_compared ? TexelFormat::float32 : TexelFormat::float16};
    const int count = std::popcount(needs.channels);
    const bool are_few = needs.driver_is_inexact && (count == 1 || count == 2);
    return {TexelFormat::unorm16, are_few ? needs.channels : all_channels};
}

std::size_t mip_level_count(int width, int height) {
    return static_cast<std::size_t>(std::bit_width(static_cast<unsigned>(std::max(width, height))));
}

std::vector<MipLevel> lower_mip_levels(const TexelSource& source, scene::ColorSpace color_space,
                                       TexelLayout layout) {
    require((color_space == scene::ColorSpace::srgb)
                == (layout.format != TexelFormat::unorm8 && layout.format != TexelFormat::unorm16),
            "the format holds the image's colour space");
    return with_types(source.image, layout, [&]<class Codec, class Code> {
        return levels_below<Codec, Code>(source, layout.channels);
    });
}

void for_each_band(const TexelSource& source, TexelLayout layout, const Take& take) {
    const scene::TextureImage& image = source.image;
    with_types(image, layout, [&]<class Codec, class Code> {
        const bool keeps_codes =
            std::is_same_v<
                Codec,
                Unorm8> || std::is_same_v<Codec, Srgb8> || (std::is_same_v<Codec, Unorm16<4>> && std::is_same_v<Code, uint16_t>);
        if (keeps_codes && !source.alpha_from)
            take(0, image.height, std::as_bytes(std::span(std::get<std::vector<Code>>(image.texels))));
        else
            convert_bands<Codec, Code>(source, layout.channels, take);
    });
}

} // namespace sr::render
