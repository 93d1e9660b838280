#pragma once
// Image files: PNG by libspng, JPEG textures and pictures that are written by libjpeg-turbo, WebP by libwebp,
// EXR by OpenEXR, all else by OpenImageIO.
#include "image/image.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <future>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace sr::image {

/// Starts loading OpenImageIO on a thread of its own (some 170 ms), so that the first write() or read() that
/// needs it does not wait for all of it. Optional: they load it themselves. The future's end
/// waits for the thread; its get() throws Error where they would.
[[nodiscard]] std::future<void> preload();

/// How an .exr stores its values; the other formats have but one way each. `half` ends at 65504: larger
/// values are stored as that (half_overflow_count() tells how many there are), those below 3e-8 as 0.
enum class SampleType { half, floating, integer8 };

/// Writes an image whole or not at all (a temporary file beside it, then a rename). The extension chooses the
/// format: .exr and .hdr take linear values; .png and .jpg take values already encoded for display, in 0..1.
/// .hdr and .jpg hold RGB only: of more channels they get the first three, of fewer the first as grey. .png
/// holds up to four. Attributes are written to .exr and .png.
/// @throws Error if the extension is unknown or the file cannot be written (named: folder missing, disk full,
/// …).
void write(const Image& image, const std::filesystem::path& file, SampleType type);

/// Returns whether write() of this file loads OpenImageIO. @throws Error as is_scene_referred()
bool loads_openimageio(const std::filesystem::path& file);

/// Returns whether the format that the extension names holds scene-referred floats (.exr, .hdr).
/// @throws Error for an extension that is not one of .exr .hdr .png .jpg .jpeg.
bool is_scene_referred(const std::filesystem::path& file);

/// Reads any image OpenImageIO knows as floats, unconverted (integers become 0..1), with channel names and
/// those attributes that are text.
/// @throws Error if there is no such file, or it is broken or of no known format.
Image read(const std::filesystem::path& file);

/// A texture decoded from memory: RGBA, rows from top to bottom, values as stored (no colour conversion).
struct DecodedTexture {
    int width = 0;
    int height = 0;
    std::variant<std::vector<std::uint8_t>, std::vector<std::uint16_t>> texels; // 4 * width * height
};

/// Counts the texels that the header of a texture claims; 0 if the head is broken or of an unknown format.
std::uint64_t claimed_texels(std::span<const std::uint8_t> bytes);

/// Returns whether it is KTX2 (its identifier: KTX 2.0 specification, section 3.1), which nothing here
/// decodes.
bool is_ktx2(std::span<const std::uint8_t> bytes);

/// Decodes a PNG, a JPEG, or a WebP if decodes_webp(). Grey becomes RGB, missing alpha is opaque. `name` is
/// what errors call it. Any number of threads may decode at once. The dimensions are checked before anything
/// is allocated for them.
/// @throws Error for another format, a broken file, and one wider or higher than 16384 or of more than 2^26
/// texels.
DecodedTexture decode_texture(std::span<const std::uint8_t> bytes, const std::string& name);

// The range of half floats, as .exr stores them on demand.

inline constexpr float max_half = 65504.0f; // IEEE 754 binary16

/// Counts the values of the image beyond ±65504.
inline std::size_t half_overflow_count(const Image& image) {
    return static_cast<std::size_t>(
        std::ranges::count_if(image.pixels, [](float value) { return std::abs(value) > max_half; }));
}

/// The image with those values at the end of the range. What is no number stays so.
inline Image within_half(Image image) {
    for (float& value : image.pixels)
        if (std::abs(value) > max_half) value = std::copysign(max_half, value);
    return image;
}

} // namespace sr::image
