#pragma once
// A glTF file that is read once and evaluated at many times.
//
//     Asset asset(file);
//     scene::Scene scene = asset.rest_pose();
//     scene = asset.evaluate(std::move(scene), {asset.animations_named("Walk"), 1.5});
#include "gltf/source_file.hpp"
#include "scene/scene.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace sr::gltf {

struct AssetOptions {
    /// The index of the file's scene; absent: its default scene, or the first.
    std::optional<int> scene{};
    /// A name of KHR_materials_variants; empty: the materials that the primitives name themselves.
    std::string variant{};
    /// Whatever would be a warning is an Error.
    bool is_strict = false;
};

/// The contents of a file besides what its Scene shows.
struct Contents {
    struct AnimationInfo {
        std::string name;
        double duration = 0.0;    // [s]
        std::size_t channels = 0; // that move something
        bool is_whole = true;     // false: channels are broken; it may have been longer
    };
    std::vector<AnimationInfo> animations;
    std::vector<std::string> variants;
    std::size_t skins = 0;
    std::size_t morph_targets = 0; // of all primitives
    std::vector<std::string> extensions_used;
    std::vector<std::string> extensions_required;
    /// Where in the file things of its Scene at rest come from: the node of each light, and the number of
    /// each material; negative for glTF's default material.
    std::vector<int> light_nodes;
    std::vector<int> material_numbers;
    struct NodeInfo {
        std::string name;
        std::vector<int> children;
    };
    std::vector<NodeInfo> nodes; // of the file, also those that its Scene does not show
};

/// A time of one or more animations, which play at once. The later one wins where two move the same property.
struct AnimationTime {
    std::vector<int> animations; // indices into Contents::animations
    double seconds = 0.0;
};

class Asset {
public:
    /// Reads a .gltf or .glb file and everything it refers to.
    /// @throws Error on any file that is not valid enough to be rendered, on a required extension that is not
    /// supported, and on a scene or a variant that is not there
    explicit Asset(const std::filesystem::path& file, const AssetOptions& options = {});
    /// The same of a file that has been read. What it refers to is read from its folder.
    explicit Asset(const SourceFile& source, const AssetOptions& options = {});
    ~Asset();
    Asset(Asset&&) noexcept;
    Asset& operator=(Asset&&) noexcept;

    const Contents& contents() const;
    /// The bytes that all of it was made of.
    const SourceFile& source() const;
    /// One line each, already prefixed with the file's name: what the file asks for and does not get, at rest
    /// and at the times evaluated so far. New ones come last.
    std::vector<std::string> warnings() const;

    /// The scene without its animations. Call it once: the images move out with it.
    scene::Scene rest_pose();

    /// Returns the scene at a time. `scene` comes from this asset, perhaps by way of a RenderScene, whose
    /// additions are dropped. Images, textures and meshes that keep their shape stay; instances, lights,
    /// cameras, materials and meshes that deform are rebuilt.
    /// @throws Error if a value that an animation takes makes no sense where it goes
    scene::Scene evaluate(scene::Scene scene, const AnimationTime& time);

    /// Evaluates in place. After an Error the scene is incomplete: evaluate it at another time.
    void evaluate_into(scene::Scene& scene, const AnimationTime& time);

    /// The node of each light of the scene that was returned last. Lights that are not visible at that time
    /// are not in it.
    const std::vector<int>& light_nodes() const;

    /// The animations that a person names: by name, by index, "all", or the first for an empty text.
    /// @throws Error naming those there are
    std::vector<int> animations_named(std::string_view text) const;

    /// When the last of the animations ends [s].
    double duration(const std::vector<int>& animations) const;

    /// @throws Error unless the time is within its animations, in 32-bit floats
    void require_within(const AnimationTime& time) const;

private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

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
/// @throws Error as Asset does, and for a time beyond the animation's end
Loaded load(const std::filesystem::path& file, const LoadOptions& options = {});

/// Returns the scene that the options name. The asset has returned none yet.
scene::Scene build_scene(Asset& asset, const LoadOptions& options);

} // namespace sr::gltf
