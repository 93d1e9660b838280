#pragma once
// glTF 2.0 → Scene.
#include "gltf/asset.hpp"

namespace sr::gltf {

struct LoadOptions {
    /// Index of a scene of the file; absent: its default scene, or the first.
    std::optional<int> scene{};
    /// When [s]; absent: the file's rest pose.
    std::optional<double> at{};
    /// As Asset::animations_named() takes it.
    std::string animation{};
    /// A name of KHR_materials_variants; empty: none.
    std::string variant{};
    /// As AssetOptions has it.
    bool is_strict = false;
};

struct Loaded {
    scene::Scene scene;
    /// One line each, already prefixed with the file's name: what the file asks for and does not get.
    std::vector<std::string> warnings;
    Contents contents;
};

/// Reads a .gltf or .glb file and everything it refers to.
/// @throws Error as Asset does, and for a moment beyond the animation's end
Loaded load(const std::filesystem::path& file, const LoadOptions& options = {});

/// The scene that the options ask for, of an asset that has given none yet.
scene::Scene scene_of(Asset& asset, const LoadOptions& options);

} // namespace sr::gltf
