#pragma once
// The module's side of image/codec.hpp.
#include "image/codec.hpp"

#include <string_view>

namespace sr::image::oiio {

std::vector<std::uint8_t> encode(const Image& image, Format format, const std::string& name);
Image read(const std::filesystem::path& file, std::uint64_t max_values);

/// OpenImageIO's messages as part of one line.
std::string one_line(std::string_view message);

} // namespace sr::image::oiio
