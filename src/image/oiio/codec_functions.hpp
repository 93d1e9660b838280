#pragma once
// The module's side of image/codec.hpp.
#include "image/codec.hpp"

namespace sr::image::oiio {

std::vector<std::uint8_t> encode_hdr(const Image& image, const std::string& name);
Image read(const std::filesystem::path& file, std::uint64_t max_values);

} // namespace sr::image::oiio
