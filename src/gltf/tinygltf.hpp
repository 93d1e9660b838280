#pragma once
// The one use of tinygltf: JSON → structs. Bytes, files and images stay with document.cpp.
#include <nlohmann/json.hpp>
#include <tiny_gltf.h>

#include <string>

namespace sr::gltf {

/// Maps a checked glTF JSON onto tinygltf's structs. The model has no buffers, images, skins or animations:
/// Document has those.
/// @throws Error calling the file `name`
tinygltf::Model parse_model(nlohmann::json root, const std::string& name);

/// A number within an extension's object, or `fallback`.
double number_in(const tinygltf::Value& object, const std::string& key, double fallback);

/// A whole number within an extension's object, or `fallback`.
int whole_in(const tinygltf::Value& object, const std::string& key, int fallback);

/// The extension's object; null where it is absent.
const tinygltf::Value* extension(const tinygltf::ExtensionMap& extensions, const std::string& name);

} // namespace sr::gltf
