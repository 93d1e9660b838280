#pragma once
// Text from a file, fit for a one-line message.
#include <string>
#include <string_view>

namespace sr::gltf {

/// The text in double quotes, without control characters and at most 80 bytes of it.
std::string in_quotes(std::string_view text);

} // namespace sr::gltf
