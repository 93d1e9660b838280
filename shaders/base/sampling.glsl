// Low-discrepancy points: the two-dimensional Sobol sequence with Owen scrambling.
// The C++ side draws sub-pixel positions from the same functions (src/render/sampling.cpp).

// A random permutation of 32-bit integers: one round of PCG. Source: Jarzynski & Olano 2020, Listing 4 (RXS-M-XS).
uint hash(uint v) {
    uint state = v * 747796405u + 2891336453u;
    uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
    return (word >> 22u) ^ word;
}

uint hash(uint a, uint b) { return hash(a ^ hash(b)); }

// Owen's nested uniform scramble of a number whose bits are already reversed.
// Source: Laine & Karras 2011, section 3.1; the constants are Burley 2020, Listing 1.
uint scramble_reversed(uint x, uint seed) {
    x += seed;
    x ^= x * 0x6c50b47cu;
    x ^= x * 0xb82f1e52u;
    x ^= x * 0xc7afe638u;
    x ^= x * 0x8d22f6e6u;
    return x;
}

// The second Sobol coordinate's bits, lowest digit first, from the index: Pascal's triangle modulo 2 as a
// matrix, applied in log2(32) steps. Source: Ahmed 2024, "An implementation algorithm of 2D Sobol sequence".
uint pascal_times(uint v) {
    v ^= (v & 0xaaaaaaaau) >> 1u;
    v ^= (v & 0xccccccccu) >> 2u;
    v ^= (v & 0xf0f0f0f0u) >> 4u;
    v ^= (v & 0xff00ff00u) >> 8u;
    v ^= (v & 0xffff0000u) >> 16u;
    return v;
}

// 24 bits are what a float in [0, 1) holds exactly.
float unit_float(uint bits) { return float(bits >> 8u) * (1.0 / 16777216.0); }

// The point in [0, 1)² that has these digits to base 2, the first one lowest, scrambled apart from each other.
vec2 scrambled_point(uvec2 digits, uint seed) {
    uint u = bitfieldReverse(scramble_reversed(digits.x, hash(seed, 1u)));
    uint v = bitfieldReverse(scramble_reversed(digits.y, hash(seed, 2u)));
    return vec2(unit_float(u), unit_float(v));
}

// Point `index` of the sequence that `seed` names, in [0, 1)². Any 2^k consecutive aligned points are
// stratified; sequences of different seeds are independent (index shuffled, digits scrambled; Burley 2020).
vec2 sobol_2d(uint index, uint seed) {
    uint shuffled = bitfieldReverse(scramble_reversed(bitfieldReverse(index), hash(seed)));
    return scrambled_point(uvec2(shuffled, pascal_times(shuffled)), seed);
}
