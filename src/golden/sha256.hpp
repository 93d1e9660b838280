#pragma once
// SHA-256: fingerprints of pictures, and the hashes of a page's Content-Security-Policy, which take no other.
#include <array>
#include <cstdint>
#include <span>
#include <string>

namespace sr::golden {

using Digest = std::array<std::uint8_t, 32>;

/// SHA-256, NIST FIPS 180-4.
Digest sha256(std::span<const std::uint8_t> bytes);

/// 64 lower-case hexadecimal digits.
std::string hexadecimal(const Digest& digest);

} // namespace sr::golden
