#pragma once
// Bytes that somebody else keeps.
#include <cstdint>
#include <span>

namespace sr::gltf {

using Bytes = std::span<const std::uint8_t>;

} // namespace sr::gltf
