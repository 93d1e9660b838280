#pragma once
// The uses of tinygltf: the geometry of a JSON → structs, and base64. Bytes, files and all else stay with
// document.cpp.
#include "gltf/container.hpp"

#include <nlohmann/json.hpp>
#include <tiny_gltf.h>

#include <memory>
#include <string>

namespace sr::gltf {

/// Maps the accessors, buffer views and meshes of a checked glTF JSON onto tinygltf's structs.
/// @throws Error calling the file `name`
std::shared_ptr<tinygltf::Model> parse_geometry(const nlohmann::json& root, const std::string& name);

/// RFC 4648, section 4. At most 4 GiB.
std::string base64(Bytes bytes);

} // namespace sr::gltf
