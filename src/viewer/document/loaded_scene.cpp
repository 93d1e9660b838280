#include "viewer/document/loaded_scene.hpp"

#include "core/error.hpp"

#include <algorithm>
#include <chrono>

namespace sr::viewer {
namespace {

/// Records the file's contents, before surfaces of lights and softboxes are added.
void record_contents(LoadedScene& loaded, const scene::Scene& scene, const gltf::Asset& asset) {
    loaded.bounds = scene::bounds_of(scene);
    loaded.base = {scene.meshes.size(), scene.materials.size(), scene.instances.size()};
    loaded.light_nodes = asset.light_nodes();
    loaded.emission.clear();
    for (const scene::Material& material : scene.materials) loaded.emission.push_back(material.emission);
}

/// Opens the file with the requested variant, or with none if the file has lost it.
gltf::Asset open_asset(const gltf::SourceFile& source, const Options& options, LoadedScene& loaded) {
    loaded.variant = options.variant;
    if (!options.is_reloading || options.variant.empty())
        return gltf::Asset(source, {options.scene_index, options.variant, options.is_strict});
    try {
        return gltf::Asset(source, {options.scene_index, options.variant, options.is_strict});
    } catch (const Error& error) {
        gltf::Asset plain(source, {options.scene_index, {}, options.is_strict});
        loaded.variant.clear();
        loaded.remarks.emplace_back(error.what());
        return plain;
    }
}

/// Chooses the animations and the time.
void choose_moment(LoadedScene& loaded, const gltf::Asset& asset, const Options& options) {
    if (asset.contents().animations.empty() && options.is_reloading) return;
    const bool is_asked = options.at || options.plays || !options.animation.empty();
    if (asset.contents().animations.empty() && !is_asked) return;
    try {
        loaded.animations = asset.animations_named(options.animation);
    } catch (const Error& error) {
        if (!options.is_reloading) throw;
        loaded.animations = {0};
        loaded.remarks.emplace_back(error.what());
    }
    if (!options.at && !options.plays) return;
    loaded.moment = {loaded.animations, options.at.value_or(0.0)};
    if (options.is_reloading)
        loaded.moment.seconds = std::min(loaded.moment.seconds, asset.duration(loaded.animations));
    asset.require_within(loaded.moment);
}

} // namespace

scene::Bounds bounds_of(const scene::Scene& scene, ObjectId object) {
    scene::Bounds bounds;
    for (const scene::Instance& instance : scene.instances) {
        if (!object.is_of(instance)) continue;
        for (const vec3 position : scene.meshes[static_cast<std::size_t>(instance.mesh)].positions)
            bounds.extend(vec3(instance.world_from_object * vec4(position, 1.0f)));
    }
    return bounds;
}

LoadedScene load_scene(const std::string& file, const Options& options, float aspect_ratio) {
    return load_scene(gltf::read_source(file), options, aspect_ratio);
}

LoadedScene load_scene(const gltf::SourceFile& source, const Options& options, float aspect_ratio) {
    const auto begin = std::chrono::steady_clock::now();
    LoadedScene result;
    gltf::Asset asset = open_asset(source, options, result);
    choose_moment(result, asset, options);
    scene::Scene scene = asset.rest_pose();
    if (!result.moment.animations.empty()) asset.evaluate_into(scene, result.moment);
    result.file = source.path.string();
    result.source = asset.source();
    record_contents(result, scene, asset);
    const std::vector<std::string> warnings = asset.warnings();
    result.remarks.insert(result.remarks.end(), warnings.begin(), warnings.end());
    result.contents = asset.contents();
    result.scene_index = options.scene_index;
    if (!result.animations.empty()) result.asset = std::move(asset);
    scene::PrepareOptions stage{options.camera, options.rig, aspect_ratio, options.hide_emitters};
    stage.environment = options.environment_light;
    result.stage = scene::prepare_scene(std::move(scene), result.file, stage);
    result.remarks.insert(result.remarks.end(), result.stage.remarks.begin(), result.stage.remarks.end());
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return result;
}

void pose(LoadedScene& loaded, const gltf::AnimationTime& moment) {
    require(loaded.asset.has_value(), "something moves");
    loaded.asset->evaluate_into(loaded.stage.scene, moment);
    record_contents(loaded, loaded.stage.scene, *loaded.asset);
    loaded.moment = moment;
}

} // namespace sr::viewer
