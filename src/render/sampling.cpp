#include "render/sampling.hpp"

namespace sr::render {
namespace {

using std::uint32_t;

/// Another order of the points: the sum modulo 2 of the columns that the digits of an index choose, the first
/// one lowest. A pair of coordinates in another order is as even as before. These orders also let the pairs
/// fill the boxes of four and of six dimensions evenly. Source: `build/find_point_orders 226`.
using Order = std::array<uint32_t, 20>;
constexpr Order order_of_points{0x1,    0x3,    0x4,     0xd,     0x11,    0x32,   0x57,
                                0x81,   0x16c,  0x268,   0x7e5,   0x886,   0x15b7, 0x3997,
                                0x4564, 0xd532, 0x1878f, 0x3db92, 0x5245a, 0xb77d6};
constexpr Order order_of_further_points{0x1,    0x3,    0x4,     0xa,     0x17,    0x2f,   0x5b,
                                        0xdd,   0x1e8,  0x284,   0x70b,   0x970,   0x18be, 0x3e4c,
                                        0x5fd4, 0xe878, 0x1777e, 0x3e6e5, 0x72e41, 0x8d3a7};

uint32_t hash(uint32_t v) {
    const uint32_t state = v * 747796405u + 2891336453u;
    const uint32_t word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
    return (word >> 22u) ^ word;
}

uint32_t hash(uint32_t a, uint32_t b) { return hash(a ^ hash(b)); }

uint32_t reversed(uint32_t v) {
    v = ((v >> 1) & 0x55555555u) | ((v & 0x55555555u) << 1);
    v = ((v >> 2) & 0x33333333u) | ((v & 0x33333333u) << 2);
    v = ((v >> 4) & 0x0f0f0f0fu) | ((v & 0x0f0f0f0fu) << 4);
    v = ((v >> 8) & 0x00ff00ffu) | ((v & 0x00ff00ffu) << 8);
    return (v >> 16) | (v << 16);
}

uint32_t scramble_reversed(uint32_t x, uint32_t seed) {
    x += seed;
    x ^= x * 0x6c50b47cu;
    x ^= x * 0xb82f1e52u;
    x ^= x * 0xc7afe638u;
    x ^= x * 0x8d22f6e6u;
    return x;
}

uint32_t pascal_times(uint32_t v) {
    v ^= (v & 0xaaaaaaaau) >> 1;
    v ^= (v & 0xccccccccu) >> 2;
    v ^= (v & 0xf0f0f0f0u) >> 4;
    v ^= (v & 0xff00ff00u) >> 8;
    v ^= (v & 0xffff0000u) >> 16;
    return v;
}

/// The index, in an order that a seed names, with blocks of 2^k indices in their places (Burley 2020).
uint32_t shuffled(uint32_t index, uint32_t seed) {
    return reversed(scramble_reversed(reversed(index), hash(seed)));
}

/// The seed of the points that all pixels share: another than any pixel's.
uint32_t seed_of_samples(uint32_t seed) { return hash(seed, 0x5a3d1e7bu); }

uint32_t place_in(const Order& order, uint32_t index) {
    uint32_t place = index >> order.size() << order.size(); // as it is, from the millionth sample on
    for (std::size_t k = 0; k < order.size(); ++k)
        if ((index >> k & 1u) != 0) place ^= order[k];
    return place;
}

float unit_float(uint32_t bits) { return static_cast<float>(bits >> 8) * (1.0f / 16777216.0f); }

} // namespace

vec2 sobol_2d(uint32_t index, uint32_t seed) {
    const uint32_t digits = shuffled(index, seed);
    const uint32_t u = reversed(scramble_reversed(digits, hash(seed, 1u)));
    const uint32_t v = reversed(scramble_reversed(pascal_times(digits), hash(seed, 2u)));
    return {unit_float(u), unit_float(v)};
}

vec2 sub_pixel(int index, int count, uint32_t seed) {
    if (count == 1) return vec2(0.5f);
    return sobol_2d(static_cast<uint32_t>(index), seed_of_samples(seed));
}

std::array<uint32_t, 4> sample_digits(int index, uint32_t seed) {
    const uint32_t place = shuffled(static_cast<uint32_t>(index), seed_of_samples(seed));
    const uint32_t first = place_in(order_of_points, place),
                   further = place_in(order_of_further_points, place);
    return {first, pascal_times(first), further, pascal_times(further)};
}

uint32_t half_seed(int half, uint32_t seed) {
    // The first half's samples are those of a rendering with that seed alone; the other's are no neighbour's.
    return half == 0 ? seed : hash(seed, 0x7f4a7c15u);
}

} // namespace sr::render
