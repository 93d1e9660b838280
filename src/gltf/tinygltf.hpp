#pragma once
// The one use of tinygltf: the geometry of a JSON → structs. Bytes, files and all else stay with
// document.cpp.
#include <nlohmann/json.hpp>
#include <tiny_gltf.h>

#include <memory>
#include <string>

namespace sr::gltf {

/// Maps the accessors, buffer views and meshes of a checked glTF JSON onto tinygltf's structs.
/// @throws Error calling the file `name`
std::shared_ptr<tinygltf::Model> parse_geometry(const nlohmann::json& root, const std::string& name);

} // namespace sr::gltf
