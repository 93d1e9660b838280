#pragma once
// OpenEXR files by OpenEXR itself, which loads in some milliseconds.
#include "image/file.hpp"

#include <optional>

namespace sr::image {

/// Encodes the image as an EXR of floats or halves, with its channel names and attributes. `name` is what
/// errors call it. @throws Error if an attribute has no name, or a name of another type
std::vector<std::uint8_t> encode_exr(const Image& image, SampleType type, const std::string& name);

/// Reads a plain EXR: one flat part of scan lines with no channels but R, G, B and A, which fills its display
/// window. Absent for all other files, which OpenImageIO reads. @throws Error if it has more than
/// `max_values` numbers, or is broken
std::optional<Image> read_plain_exr(const std::filesystem::path& file, std::uint64_t max_values);

} // namespace sr::image
