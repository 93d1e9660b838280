#pragma once
// A fingerprint of a file's bytes.
#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

namespace sr::golden {

using Digest = std::array<std::uint8_t, 32>;

/// SHA-256, NIST FIPS 180-4.
Digest sha256(std::span<const std::uint8_t> bytes);

/// 64 lower-case hexadecimal digits.
std::string hexadecimal(const Digest& digest);

/// The SHA-256 of a file's bytes in hexadecimal. @throws Error if it cannot be read.
std::string sha256_of_file(const std::filesystem::path& file);

} // namespace sr::golden
