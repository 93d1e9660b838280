#pragma once
// A file in memory, set before a camera: everything of a scene that needs no GL, so that any thread can make
// it.
#include "gltf/asset.hpp"
#include "viewer/eye.hpp"
#include "viewer/options.hpp"

#include <filesystem>

namespace sr::viewer {

/// How many of each were there before lights got surfaces and softboxes came.
struct BaseCounts {
    std::size_t meshes = 0;
    std::size_t materials = 0;
    std::size_t instances = 0;
    std::size_t file_lights = 0;
};

struct LoadedScene {
    std::string file;
    scene::Stage stage;
    scene::Bounds bounds;           // of what the file has
    std::optional<int> scene_index; // that was asked for
    BaseCounts base;
    gltf::Contents contents;
    std::optional<gltf::Asset> asset; // what poses the scene; absent: nothing in it moves
    gltf::Moment moment;              // that is shown; without animations the rest pose
    std::vector<int> animations;      // those to play, as Options::animation names them
    std::string variant;              // that is shown
    std::vector<int> light_nodes;     // of the file's lights at the moment
    std::vector<vec3> emission;       // of each of the file's materials, even where emitters are hidden
    std::vector<std::string> remarks; // one line each: warnings, and what was decided without being asked
    double seconds = 0.0;             // that loading took
};

/// @throws Error; while reloading not for an animation, a time or a variant that the file no longer has
LoadedScene load_scene(const std::string& file, const Options& options, float aspect_ratio);

/// Brings what the file has to another moment, without lights' surfaces and softboxes. Only with an asset.
/// @throws Error if a value makes no sense then; the scene has to be posed again
void pose(LoadedScene& loaded, const gltf::Moment& moment);

} // namespace sr::viewer
