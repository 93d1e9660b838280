#pragma once
// Image files, through OpenImageIO.
#include "image/image.hpp"

#include <cstdint>
#include <filesystem>
#include <variant>

namespace sr::image {

enum class SampleType { half, floating, integer8 };

/// Writes an image whole or not at all (a temporary file beside it, then a rename). The extension chooses the
/// format: .exr and .hdr take linear values; .png and .jpg take values already encoded for display, in 0..1.
/// @throws Error if the extension is unknown or the file cannot be written (named: folder missing, disk full, …).
void write(const Image& image, const std::filesystem::path& file, SampleType type);

/// Whether the format that the extension names holds scene-referred floats (.exr, .hdr).
/// @throws Error for an extension that is not one of .exr .hdr .png .jpg .jpeg.
bool is_scene_referred(const std::filesystem::path& file);

/// Reads any image OpenImageIO knows as floats, unconverted, with channel names and attributes.
/// @throws Error
Image read(const std::filesystem::path& file);

/// A texture decoded from memory: RGBA, rows from top to bottom, values as stored (no colour conversion).
struct DecodedTexture {
    int width = 0;
    int height = 0;
    std::variant<std::vector<std::uint8_t>, std::vector<std::uint16_t>> texels; // 4 * width * height
};

/// Decodes a PNG, JPEG or any other image OpenImageIO can read from memory. Grey becomes RGB, missing alpha is opaque.
/// `name` is what errors call it. The dimensions are checked before anything is allocated for them.
/// @throws Error
DecodedTexture decode_texture(std::span<const std::uint8_t> bytes, const std::string& name);

} // namespace sr::image
