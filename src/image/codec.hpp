#pragma once
// The seam between this folder and OpenImageIO, which lives in a module opened at run time. Private to
// image/.
#include "image/file.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace sr::image {

/// The functions that the module offers. They throw Error, whose file is `name`.
struct Codec {
    std::vector<std::uint8_t> (*encode_hdr)(const Image& image, const std::string& name);
    /// Refuses images of more than `max_values` numbers.
    Image (*read)(const std::filesystem::path& file, std::uint64_t max_values);
};

/// The module's one symbol is a function of this type.
using CodecEntry = const Codec* (*)();
inline constexpr const char* codec_entry_name = "steradian_image_codec";

/// Opens the module at the first call and waits for it; any number of threads may ask.
/// @throws Error if it is missing or cannot be loaded.
const Codec& codec();

} // namespace sr::image
