#pragma once
// Loaded file with its RenderScene: everything of a scene that needs no GL, so that any thread can load it.
#include "gltf/asset.hpp"
#include "viewer/options.hpp"
#include "viewer/view/camera_controller.hpp"

#include <compare>
#include <filesystem>
#include <set>

namespace sr::viewer {

/// Counts before surfaces of lights and softboxes were added.
struct BaseCounts {
    std::size_t meshes = 0;
    std::size_t materials = 0;
    std::size_t instances = 0;
};

/// The instances of a mesh at a node, which are hidden and selected as one.
struct ObjectId {
    int node = -1;
    int mesh = -1;

    bool is_of(const scene::Instance& instance) const {
        return instance.node == node && instance.mesh == mesh;
    }
    auto operator<=>(const ObjectId&) const = default;
};

struct LoadedScene {
    std::string file;
    gltf::SourceFile source; // the bytes that it was made of
    scene::RenderScene stage;
    scene::Bounds bounds;           // of the file's contents
    std::optional<int> scene_index; // that was requested
    BaseCounts base;
    gltf::Contents contents;
    std::optional<gltf::Asset> asset; // poses the scene; absent if it has no animations
    gltf::AnimationTime moment;       // current time; the rest pose if it has no animations
    std::vector<int> animations;      // that Options::animation names
    std::string variant;              // current material variant; empty: none
    std::vector<int> light_nodes;     // of the file's lights at the current time
    std::set<ObjectId> hidden;        // by a person
    std::vector<vec3> emission;       // of each of the file's materials, even where emitters are hidden
    std::vector<std::string> remarks; // one line each: warnings, and defaults that were chosen
    double seconds = 0.0;             // of loading
};

/// The box around the instances of an object; empty if there are none.
scene::Bounds bounds_of(const scene::Scene& scene, ObjectId object);

/// Loads a file. @throws Error; but while reloading, an animation, a time or a variant that the file has lost
/// is a remark
LoadedScene load_scene(const std::string& file, const Options& options, float aspect_ratio);

/// Loads a file again from the bytes that were read, with other options. @throws Error likewise
LoadedScene load_scene(const gltf::SourceFile& source, const Options& options, float aspect_ratio);

/// Poses the file's contents at another time, without surfaces of lights and softboxes. Needs an asset.
/// @throws Error if a value makes no sense then; the scene must be posed again
void pose(LoadedScene& loaded, const gltf::AnimationTime& moment);

} // namespace sr::viewer
