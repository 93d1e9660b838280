#pragma once
// glTF 2.0 → Scene.
#include "scene/scene.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace sr::gltf {

struct LoadOptions {
    /// Which of the file's scenes; absent: its default scene, or the first.
    std::optional<int> scene;
};

struct Loaded {
    scene::Scene scene;
    /// One line each, already prefixed with the file's name: what the file asks for and does not get.
    std::vector<std::string> warnings;
    std::vector<std::string> extensions_used;
};

/// Reads a .gltf or .glb file and everything it refers to.
/// @throws Error on any file that is not valid enough to be rendered, and on a required extension that is not
/// supported.
Loaded load(const std::filesystem::path& file, const LoadOptions& options = {});

} // namespace sr::gltf
