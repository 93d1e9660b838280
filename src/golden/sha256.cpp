#include "golden/sha256.hpp"

#include <bit>
#include <cmath>
#include <fmt/format.h>
#include <vector>

namespace sr::golden {
namespace {

constexpr int rounds = 64;
using Words = std::array<std::uint32_t, rounds>;

constexpr bool is_prime(int n) {
    for (int d = 2; d * d <= n; ++d)
        if (n % d == 0) return false;
    return n > 1;
}

/// The first 32 bits of the fractional part of a positive number.
std::uint32_t fraction_bits(long double x) {
    return static_cast<std::uint32_t>((x - std::floor(x)) * 4294967296.0L);
}

/// FIPS 180-4 4.2.2 and 5.3.3: the constants are fractions of roots of the first primes.
template<std::size_t N, class Root>
std::array<std::uint32_t, N> prime_root_fractions(Root root) {
    std::array<std::uint32_t, N> words{};
    int prime = 1;
    for (std::uint32_t& word : words) {
        do ++prime;
        while (!is_prime(prime));
        word = fraction_bits(root(static_cast<long double>(prime)));
    }
    return words;
}

const Words& round_constants() {
    static const Words constants = prime_root_fractions<rounds>([](long double x) { return std::cbrt(x); });
    return constants;
}

/// FIPS 180-4 6.2.2, step 1.
Words message_schedule(const std::uint8_t* block) {
    Words w{};
    for (std::size_t t = 0; t < 16; ++t)
        for (std::size_t byte = 0; byte < 4; ++byte) w[t] = w[t] << 8 | block[4 * t + byte];
    for (std::size_t t = 16; t < rounds; ++t) {
        const std::uint32_t a = w[t - 15], b = w[t - 2];
        const std::uint32_t s0 = std::rotr(a, 7) ^ std::rotr(a, 18) ^ (a >> 3);
        const std::uint32_t s1 = std::rotr(b, 17) ^ std::rotr(b, 19) ^ (b >> 10);
        w[t] = s1 + w[t - 7] + s0 + w[t - 16];
    }
    return w;
}

/// FIPS 180-4 6.2.2, steps 2 to 4. `v` is a, b, … h.
void compress(std::array<std::uint32_t, 8>& hash, const std::uint8_t* block) {
    const Words w = message_schedule(block);
    auto v = hash;
    for (std::size_t t = 0; t < rounds; ++t) {
        const std::uint32_t s1 = std::rotr(v[4], 6) ^ std::rotr(v[4], 11) ^ std::rotr(v[4], 25);
        const std::uint32_t choice = (v[4] & v[5]) ^ (~v[4] & v[6]);
        const std::uint32_t t1 = v[7] + s1 + choice + round_constants()[t] + w[t];
        const std::uint32_t s0 = std::rotr(v[0], 2) ^ std::rotr(v[0], 13) ^ std::rotr(v[0], 22);
        const std::uint32_t majority = (v[0] & v[1]) ^ (v[0] & v[2]) ^ (v[1] & v[2]);
        v = {t1 + s0 + majority, v[0], v[1], v[2], v[3] + t1, v[4], v[5], v[6]};
    }
    for (std::size_t i = 0; i < 8; ++i) hash[i] += v[i];
}

} // namespace

Digest sha256(std::span<const std::uint8_t> bytes) {
    std::vector<std::uint8_t> padded(bytes.begin(), bytes.end());
    padded.push_back(0x80);
    while (padded.size() % 64 != 56) padded.push_back(0);
    const std::uint64_t bits = 8 * static_cast<std::uint64_t>(bytes.size());
    for (int shift = 56; shift >= 0; shift -= 8) padded.push_back(static_cast<std::uint8_t>(bits >> shift));

    auto hash = prime_root_fractions<8>([](long double x) { return std::sqrt(x); });
    for (std::size_t begin = 0; begin < padded.size(); begin += 64) compress(hash, padded.data() + begin);
    Digest digest{};
    for (std::size_t i = 0; i < digest.size(); ++i)
        digest[i] = static_cast<std::uint8_t>(hash[i / 4] >> (24 - 8 * (i % 4)));
    return digest;
}

std::string hexadecimal(const Digest& digest) {
    std::string text;
    for (const std::uint8_t byte : digest) text += fmt::format("{:02x}", byte);
    return text;
}

Digest sha256(std::string_view text) {
    return sha256(std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
}

std::string sha256_text(std::string_view text) { return hexadecimal(sha256(text)); }

} // namespace sr::golden
