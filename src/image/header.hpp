#pragma once
// Headers of images, read before any decoder allocates memory for what they claim.
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

namespace sr::image {

enum class TextureFormat { png, jpeg };

struct Header {
    TextureFormat format = TextureFormat::png;
    std::uint32_t width = 0;
    std::uint32_t height = 0;
};

/// The format and size of a PNG or JPEG, both within the limits below.
/// @throws Error in the file `name`: not a PNG or JPEG, no size in sight, too large, truncated.
Header read_header(std::span<const std::uint8_t> bytes, const std::string& name);

/// @throws Error in the file `name` if so many texels are too many
void check_size(std::uint32_t width, std::uint32_t height, const std::string& name);

/// Returns whether a file is a pointer of Git LFS: the text that stands for an image which was not fetched.
bool is_lfs_pointer(const std::filesystem::path& file);

inline constexpr std::uint32_t max_texture_size = 16384; // [texels] along an edge: what OpenGL drivers take
inline constexpr std::uint64_t max_texture_texels = 1ull << 26; // 256 MiB of 8-bit RGBA

} // namespace sr::image
