#include "render/sampling.hpp"

namespace sr::render {
namespace {

using std::uint32_t;

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

float unit_float(uint32_t bits) { return static_cast<float>(bits >> 8) * (1.0f / 16777216.0f); }

} // namespace

vec2 sobol_2d(uint32_t index, uint32_t seed) {
    const uint32_t shuffled = reversed(scramble_reversed(reversed(index), hash(seed)));
    const uint32_t u = reversed(scramble_reversed(shuffled, hash(seed, 1u)));
    const uint32_t v = reversed(scramble_reversed(pascal_times(shuffled), hash(seed, 2u)));
    return {unit_float(u), unit_float(v)};
}

vec2 sub_pixel(int index, int count, uint32_t seed) {
    if (count == 1) return vec2(0.5f);
    // Another sequence than any pixel's light points, which mix in the pixel's coordinates.
    return sobol_2d(static_cast<uint32_t>(index), hash(seed, 0x5a3d1e7bu));
}

uint32_t half_seed(int half, uint32_t seed) {
    // The first half's samples are those of a rendering with that seed alone; the other's are no neighbour's.
    return half == 0 ? seed : hash(seed, 0x7f4a7c15u);
}

} // namespace sr::render
