#include "render/gpu/mip_chain.hpp"

#include "core/error.hpp"
#include "image/display.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/packing.hpp>
#include <limits>

namespace sr::render {
namespace {

using std::uint16_t;
using std::uint32_t;
using std::uint8_t;

/// The linear value of every code of an sRGB image.
template<class Code>
const std::vector<float>& linear_of_codes() {
    static const auto table = [] {
        constexpr std::size_t max_code = std::numeric_limits<Code>::max();
        std::vector<float> linear(max_code + 1);
        for (std::size_t i = 0; i <= max_code; ++i)
            linear[i] = image::linear_of_srgb(static_cast<float>(i) / static_cast<float>(max_code));
        return linear;
    }();
    return table;
}

// A codec turns stored values into values that can be averaged, and back.

struct Unorm8 {
    using Stored = uint8_t;
    using Sum = uint32_t; // of values of 16 bits
    static Sum decode(Stored v, int) { return v * 257u; }
    static Stored encode(Sum v, int) { return static_cast<Stored>((v + 128u) / 257u); }
};

struct Unorm16 {
    using Stored = uint16_t;
    using Sum = uint32_t;
    static Sum decode(Stored v, int) { return v; }
    static Stored encode(Sum v, int) { return static_cast<Stored>(v); }
};

/// sRGB: IEC 61966-2-1. Alpha, channel 3, is linear.
struct Srgb8 {
    using Stored = uint8_t;
    using Sum = uint32_t;
    static const std::array<uint16_t, 256>& to_linear() {
        static const auto table = [] {
            std::array<uint16_t, 256> linear{};
            for (std::size_t i = 0; i < linear.size(); ++i)
                linear[i] = static_cast<uint16_t>(std::lround(linear_of_codes<uint8_t>()[i] * 65535.0f));
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
    static Sum decode(Stored v, int channel) { return channel == 3 ? Unorm8::decode(v, 3) : to_linear()[v]; }
    static Stored encode(Sum v, int channel) { return channel == 3 ? Unorm8::encode(v, 3) : to_srgb()[v]; }
};

struct Float16 {
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
    static Sum decode(Stored v, int) { return to_float()[v]; }
    static Stored encode(Sum v, int) { return glm::packHalf1x16(v); }
};

struct Float32 {
    using Stored = float;
    using Sum = float;
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

/// Both sizes even, or 1: four texels of equal weight.
template<class Codec, class T = typename Codec::Stored>
void halve_evenly(const T* from, int width, int height, T* to, int half_width, int half_height) {
    const int step_x = width > 1 ? 4 : 0;
    const std::ptrdiff_t step_y = height > 1 ? static_cast<std::ptrdiff_t>(width) * 4 : 0;
    for (int y = 0; y < half_height; ++y) {
        const T* row = from + static_cast<std::ptrdiff_t>(height > 1 ? 2 * y : 0) * width * 4;
        for (int x = 0; x < half_width; ++x, row += 2 * step_x) {
            for (int c = 0; c < 4; ++c) {
                const auto sum = Codec::decode(row[c], c) + Codec::decode(row[c + step_x], c)
                                 + Codec::decode(row[c + step_y], c)
                                 + Codec::decode(row[c + step_x + step_y], c);
                *to++ = Codec::encode(quarter(sum), c);
            }
        }
    }
}

template<class Codec, class T = typename Codec::Stored>
void halve_by_area(const T* from, int width, int height, T* to, int half_width, int half_height) {
    std::vector<Taps> columns;
    for (int x = 0; x < half_width; ++x) columns.push_back(taps_of(x, half_width, width));
    for (int y = 0; y < half_height; ++y) {
        const Taps rows = taps_of(y, half_height, height);
        for (const Taps& taps : columns) {
            for (int c = 0; c < 4; ++c) {
                float sum = 0.0f;
                for (int j = 0; j < rows.count; ++j)
                    for (int i = 0; i < taps.count; ++i) {
                        const auto texel =
                            static_cast<std::ptrdiff_t>(rows.first + j) * width + taps.first + i;
                        sum += rows.weights[static_cast<std::size_t>(j)]
                               * taps.weights[static_cast<std::size_t>(i)]
                               * static_cast<float>(Codec::decode(from[4 * texel + c], c));
                    }
                *to++ = Codec::encode(rounded_to<typename Codec::Sum>(sum), c);
            }
        }
    }
}

template<class T>
MipLevel empty_level(int width, int height) {
    MipLevel level{width, height, {}, {}};
    level.own_storage.resize(static_cast<std::size_t>(width) * height * 4 * sizeof(T));
    level.texels = level.own_storage;
    return level;
}

template<class T>
T* values_of(MipLevel& level) {
    return reinterpret_cast<T*>(level.own_storage.data());
}

/// Appends the levels below level 0.
template<class Codec>
void append_halves(std::vector<MipLevel>& levels) {
    using T = typename Codec::Stored;
    while (levels.back().width > 1 || levels.back().height > 1) {
        const int width = levels.back().width, height = levels.back().height;
        MipLevel level = empty_level<T>(std::max(1, width / 2), std::max(1, height / 2));
        const bool is_even = (width % 2 == 0 || width == 1) && (height % 2 == 0 || height == 1);
        const auto halve = is_even ? halve_evenly<Codec, T> : halve_by_area<Codec, T>;
        halve(reinterpret_cast<const T*>(levels.back().texels.data()), width, height, values_of<T>(level),
              level.width, level.height);
        levels.push_back(std::move(level));
    }
}

/// Returns level 0 with each code replaced by color[code], or alpha[code] in channel 3.
template<class Code, class T>
MipLevel converted(const scene::TextureImage& image, const std::vector<T>& color,
                   const std::vector<T>& alpha) {
    const auto& codes = std::get<std::vector<Code>>(image.texels);
    MipLevel level = empty_level<T>(image.width, image.height);
    T* values = values_of<T>(level);
    for (std::size_t i = 0; i < codes.size(); i += 4) {
        for (std::size_t c = 0; c < 3; ++c) values[i + c] = color[codes[i + c]];
        values[i + 3] = alpha[codes[i + 3]];
    }
    return level;
}

/// The value of every code: `of` maps it from 0..1.
template<class Code, class T>
std::vector<T> table(const auto& of) {
    constexpr std::size_t max_code = std::numeric_limits<Code>::max();
    std::vector<T> values(max_code + 1);
    for (std::size_t i = 0; i <= max_code; ++i)
        values[i] = of(static_cast<float>(i) / static_cast<float>(max_code));
    return values;
}

template<class Code>
MipLevel linear_floats(const scene::TextureImage& image, TexelFormat format) {
    const auto same = [](float v) { return v; };
    if (format == TexelFormat::float32)
        return converted<Code, float>(image, linear_of_codes<Code>(), table<Code, float>(same));
    return converted<Code, uint16_t>(
        image, table<Code, uint16_t>([](float v) { return glm::packHalf1x16(image::linear_of_srgb(v)); }),
        table<Code, uint16_t>([](float v) { return glm::packHalf1x16(v); }));
}

MipLevel level_0(const scene::TextureImage& image, TexelFormat format) {
    const bool is_8_bit = std::holds_alternative<std::vector<uint8_t>>(image.texels);
    if (format == TexelFormat::float16 || format == TexelFormat::float32)
        return is_8_bit ? linear_floats<uint8_t>(image, format) : linear_floats<uint16_t>(image, format);
    if (format == TexelFormat::unorm16 && is_8_bit) {
        const auto widened = table<uint8_t, uint16_t>(
            [](float v) { return static_cast<uint16_t>(std::lround(v * 65535.0f)); });
        return converted<uint8_t, uint16_t>(image, widened, widened);
    }
    const auto own = [](const auto& texels) { return std::as_bytes(std::span(texels)); };
    return {image.width, image.height, std::visit(own, image.texels), {}};
}

} // namespace

TexelFormat texel_format(const scene::TextureImage& image, scene::ColorSpace color_space, TexelNeeds needs) {
    const bool is_8_bit = std::holds_alternative<std::vector<uint8_t>>(image.texels);
    const bool is_srgb = color_space == scene::ColorSpace::srgb;
    if (is_8_bit && !needs.driver_is_inexact) return is_srgb ? TexelFormat::srgb8 : TexelFormat::unorm8;
    if (!is_srgb) return TexelFormat::unorm16;
    return needs.alpha_is_compared ? TexelFormat::float32 : TexelFormat::float16;
}

std::vector<MipLevel> mip_chain(const scene::TextureImage& image, scene::ColorSpace color_space,
                                TexelFormat format) {
    require((color_space == scene::ColorSpace::srgb)
                == (format != TexelFormat::unorm8 && format != TexelFormat::unorm16),
            "the format holds the image's colour space");
    std::vector<MipLevel> levels;
    levels.push_back(level_0(image, format));
    switch (format) {
    case TexelFormat::unorm8: append_halves<Unorm8>(levels); break;
    case TexelFormat::srgb8: append_halves<Srgb8>(levels); break;
    case TexelFormat::unorm16: append_halves<Unorm16>(levels); break;
    case TexelFormat::float16: append_halves<Float16>(levels); break;
    case TexelFormat::float32: append_halves<Float32>(levels); break;
    }
    return levels;
}

} // namespace sr::render
