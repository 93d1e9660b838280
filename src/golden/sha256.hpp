#pragma once
// SHA-256: fingerprints of pictures, and the hashes of a page's Content-Security-Policy, which take no other.
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace sr::golden {

using Digest = std::array<std::uint8_t, 32>;

/// SHA-256, NIST FIPS 180-4.
Digest sha256(std::span<const std::uint8_t> bytes);

/// The digest of the bytes of a text.
Digest sha256(std::string_view text);

/// 64 lower-case hexadecimal digits.
std::string hexadecimal(const Digest& digest);

/// SHA-256 of a text in hexadecimal.
std::string sha256_text(std::string_view text);

} // namespace sr::golden
