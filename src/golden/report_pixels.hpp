#pragma once
// Float pixels as text that a report carries.
#include "image/image.hpp"

#include <nlohmann/json_fwd.hpp>
#include <string_view>

namespace sr::golden {

/// {"width", "height", "scale", "data"}: R, G and B times `scale` (a power of two that makes the best of the
/// range of half floats) as halves, for each channel all high bytes and then all low bytes, deflated (RFC
/// 1950), base64. A half has 11 significant bits: a value in a report is right within 0.05 %.
nlohmann::ordered_json packed_pixels(const image::Image& image);

/// RFC 4648 section 4.
std::string base64(std::string_view bytes);

} // namespace sr::golden
