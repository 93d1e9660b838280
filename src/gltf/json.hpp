#pragma once
// The JSON text of a glTF file, with errors that say where it is broken.
#include "gltf/container.hpp"

#include <nlohmann/json.hpp>

namespace sr::gltf {

/// Parses the container's JSON. A .gltf's errors carry line and column, a GLB's the byte of the file.
/// @throws Error if the text is no JSON, is nested deeper than 128 levels (recursive readers would exhaust
/// their stack), or is no object.
nlohmann::json parse(const Container& container, const std::string& name);

/// The same, with the members of each object in the file's order.
nlohmann::ordered_json parse_ordered(const Container& container, const std::string& name);

} // namespace sr::gltf
