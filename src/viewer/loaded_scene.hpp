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
    std::vector<vec3> emission;       // of each of the file's materials, even where emitters are hidden
    std::vector<std::string> remarks; // one line each: warnings, and what was decided without being asked
    double seconds = 0.0;             // that loading took
};

/// @throws Error
LoadedScene load_scene(const std::string& file, const Options& options, float aspect_ratio);

} // namespace sr::viewer
