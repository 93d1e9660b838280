#include "render/mip_chain.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace sr::render {
namespace {

using std::uint16_t;
using std::uint32_t;
using std::uint8_t;

/// Between stored values and values that may be averaged, both ways. Averages are formed in 16 bits or more.
struct PlainBytes {
    static uint32_t opened(uint8_t v, int) { return v * 257u; }
    static uint8_t closed(uint32_t v, int) { return static_cast<uint8_t>((v + 128u) / 257u); }
};

struct PlainWords {
    static uint32_t opened(uint16_t v, int) { return v; }
    static uint16_t closed(uint32_t v, int) { return static_cast<uint16_t>(v); }
};

/// sRGB: IEC 61966-2-1. Alpha, channel 3, is linear.
struct SrgbBytes {
    static double decoded(double s) { return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4); }
    static double encoded(double l) {
        return l <= 0.0031308 ? 12.92 * l : 1.055 * std::pow(l, 1.0 / 2.4) - 0.055;
    }

    static const std::array<uint16_t, 256>& to_linear() {
        static const auto table = [] {
            std::array<uint16_t, 256> t{};
            for (std::size_t i = 0; i < t.size(); ++i)
                t[i] = static_cast<uint16_t>(std::lround(decoded(static_cast<double>(i) / 255.0) * 65535.0));
            return t;
        }();
        return table;
    }
    static const std::vector<uint8_t>& to_srgb() {
        static const auto table = [] {
            std::vector<uint8_t> t(65536);
            for (std::size_t i = 0; i < t.size(); ++i)
                t[i] = static_cast<uint8_t>(std::lround(encoded(static_cast<double>(i) / 65535.0) * 255.0));
            return t;
        }();
        return table;
    }
    static uint32_t opened(uint8_t v, int channel) {
        return channel == 3 ? PlainBytes::opened(v, 3) : to_linear()[v];
    }
    static uint8_t closed(uint32_t v, int channel) {
        return channel == 3 ? PlainBytes::closed(v, 3) : to_srgb()[v];
    }
};

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

/// Both sizes even, or 1: four texels of equal weight, in integers.
template<class Code, class T>
void halve_evenly(const T* from, int width, int height, T* to, int half_width, int half_height) {
    const int step_x = width > 1 ? 4 : 0;
    const std::ptrdiff_t step_y = height > 1 ? static_cast<std::ptrdiff_t>(width) * 4 : 0;
    for (int y = 0; y < half_height; ++y) {
        const T* row = from + static_cast<std::ptrdiff_t>(height > 1 ? 2 * y : 0) * width * 4;
        for (int x = 0; x < half_width; ++x, row += 2 * step_x) {
            for (int c = 0; c < 4; ++c) {
                const uint32_t sum = Code::opened(row[c], c) + Code::opened(row[c + step_x], c)
                                     + Code::opened(row[c + step_y], c)
                                     + Code::opened(row[c + step_x + step_y], c);
                *to++ = Code::closed((sum + 2u) / 4u, c);
            }
        }
    }
}

template<class Code, class T>
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
                               * static_cast<float>(Code::opened(from[4 * texel + c], c));
                    }
                *to++ = Code::closed(static_cast<uint32_t>(std::min(sum + 0.5f, 65535.0f)), c);
            }
        }
    }
}

template<class Code, class T>
std::vector<MipLevel> chain(const std::vector<T>& texels, int width, int height) {
    std::vector<MipLevel> levels;
    const T* from = texels.data();
    while (width > 1 || height > 1) {
        MipLevel level{std::max(1, width / 2), std::max(1, height / 2), std::vector<T>{}};
        auto& to = std::get<std::vector<T>>(level.texels);
        to.resize(static_cast<std::size_t>(level.width) * level.height * 4);
        const bool is_even = (width % 2 == 0 || width == 1) && (height % 2 == 0 || height == 1);
        const auto halve = is_even ? halve_evenly<Code, T> : halve_by_area<Code, T>;
        halve(from, width, height, to.data(), level.width, level.height);
        from = to.data();
        width = level.width;
        height = level.height;
        levels.push_back(std::move(level));
    }
    return levels;
}

} // namespace

std::vector<MipLevel> mip_chain(const scene::TextureImage& image, scene::ColorSpace color_space) {
    if (const auto* words = std::get_if<std::vector<uint16_t>>(&image.texels))
        return chain<PlainWords>(*words, image.width, image.height);
    const auto& bytes = std::get<std::vector<uint8_t>>(image.texels);
    if (color_space == scene::ColorSpace::srgb) return chain<SrgbBytes>(bytes, image.width, image.height);
    return chain<PlainBytes>(bytes, image.width, image.height);
}

} // namespace sr::render
