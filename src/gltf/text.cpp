#include "gltf/text.hpp"

namespace sr::gltf {

std::string in_quotes(std::string_view text) {
    constexpr std::size_t longest = 80;
    std::string line = "\"";
    for (const char c : text.substr(0, longest)) line += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    if (text.size() > longest) line += "…";
    return line + '"';
}

} // namespace sr::gltf
