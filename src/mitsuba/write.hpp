#pragma once
// A Scene as a folder that Mitsuba 3 renders.
#include "scene/scene.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace sr::mitsuba {

/// The scene and camera to export. The scene has no surfaces of its lights yet (scene::add_light_surfaces):
/// they become emitters.
struct Subject {
    const scene::Scene& scene;
    const scene::Camera& camera;
    int width = 0; // of the picture [pixels]
    int height = 0;
};

/// Writes scene.xml, meshes/, textures/, the plugins, render.py and a README.md, all of it or nothing.
/// @return one line for everything that Mitsuba cannot say.
/// @throws Error if the folder holds anything that no export wrote, or cannot be written.
std::vector<std::string> write(const Subject& subject, const std::filesystem::path& folder);

} // namespace sr::mitsuba
