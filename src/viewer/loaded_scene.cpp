#include "viewer/loaded_scene.hpp"

#include "gltf/load.hpp"

#include <chrono>

namespace sr::viewer {

LoadedScene load_scene(const std::string& file, const Options& options, float aspect_ratio) {
    const auto begin = std::chrono::steady_clock::now();
    gltf::Loaded loaded = gltf::load(file, {options.scene_index});
    LoadedScene result;
    result.file = file;
    result.bounds = scene::bounds_of(loaded.scene);
    result.base = {loaded.scene.meshes.size(), loaded.scene.materials.size(), loaded.scene.instances.size(),
                   loaded.scene.lights.size()};
    for (const scene::Material& material : loaded.scene.materials)
        result.emission.push_back(material.emission);
    result.remarks = std::move(loaded.warnings);
    result.contents = std::move(loaded.contents);
    result.scene_index = options.scene_index;
    scene::StageOptions stage{options.camera, options.rig, aspect_ratio, options.hide_emitters};
    result.stage = scene::set_stage(std::move(loaded.scene), file, stage);
    result.remarks.insert(result.remarks.end(), result.stage.remarks.begin(), result.stage.remarks.end());
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return result;
}

} // namespace sr::viewer
