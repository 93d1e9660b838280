#pragma once
// A glTF file that is read once and posed many times.
//
//     Asset asset(file);
//     scene::Scene scene = asset.at_rest();
//     scene = asset.posed(std::move(scene), {asset.animations_named("Walk"), 1.5});
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
    struct Animation {
        std::string name;
        double duration = 0.0;    // [s]
        std::size_t channels = 0; // that move something
        bool is_whole = true;     // false: channels are broken; it may have been longer
    };
    std::vector<Animation> animations;
    std::vector<std::string> variants;
    std::size_t skins = 0;
    std::size_t morph_targets = 0; // of all primitives
    std::vector<std::string> extensions_used;
    std::vector<std::string> extensions_required;
    /// Where in the file things of its Scene at rest come from: the node of each light, and the number of
    /// each material; negative for glTF's default material.
    std::vector<int> light_nodes;
    std::vector<int> material_numbers;
};

/// A moment of one or more animations, which play at once. The later one wins where two move the same.
struct Moment {
    std::vector<int> animations; // indices into Contents::animations
    double seconds = 0.0;
};

class Asset {
public:
    /// Reads a .gltf or .glb file and everything it refers to.
    /// @throws Error on any file that is not valid enough to be rendered, on a required extension that is not
    /// supported, and on a scene or a variant that is not there
    explicit Asset(const std::filesystem::path& file, const AssetOptions& options = {});
    ~Asset();
    Asset(Asset&&) noexcept;
    Asset& operator=(Asset&&) noexcept;

    const Contents& contents() const;
    /// One line each, already prefixed with the file's name: what the file asks for and does not get, at rest
    /// and at the moments that it was posed at so far. New ones come last.
    std::vector<std::string> warnings() const;

    /// The scene as the file has it without its animations. To be called once: the images go with it.
    scene::Scene at_rest();

    /// The same scene at another moment. Images, textures and meshes that keep their shape are those of
    /// `scene`, which comes from here, perhaps by way of a RenderScene, whose additions are dropped.
    /// Instances, lights, cameras, materials and meshes that deform are made again.
    /// @throws Error if a value that an animation takes makes no sense where it goes
    scene::Scene posed(scene::Scene scene, const Moment& moment);

    /// The same in place, for those who could not do without the scene: after an Error it has to be posed
    /// again, at a moment that makes sense.
    void pose(scene::Scene& scene, const Moment& moment);

    /// The node of each light of the scene that was given or posed last: at some moments lights are not
    /// visible, and then not there.
    const std::vector<int>& light_nodes() const;

    /// The animations that a person names: by name, by index, "all", or the first for an empty text.
    /// @throws Error naming those there are
    std::vector<int> animations_named(std::string_view text) const;

    /// When the last of the animations ends [s].
    double duration(const std::vector<int>& animations) const;

    /// @throws Error unless the moment is within its animations, which are told in 32-bit floats
    void require_within(const Moment& moment) const;

private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace sr::gltf
