#include "gltf/compression.hpp"

namespace sr::gltf {

int add_buffer(Document& document, std::vector<std::uint8_t> bytes) {
    document.storage.push_back(std::make_unique<const std::vector<std::uint8_t>>(std::move(bytes)));
    document.buffers.push_back({*document.storage.back(), std::nullopt});
    return static_cast<int>(document.buffers.size()) - 1;
}

} // namespace sr::gltf
