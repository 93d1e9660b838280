#include "gltf/load.hpp"

namespace sr::gltf {

scene::Scene scene_of(Asset& asset, const LoadOptions& options) {
    scene::Scene scene = asset.at_rest();
    if (!options.at) return scene;
    const Moment moment{asset.animations_named(options.animation), *options.at};
    asset.require_within(moment);
    return asset.posed(std::move(scene), moment);
}

Loaded load(const std::filesystem::path& file, const LoadOptions& options) {
    Asset asset(file, {options.scene, options.variant, options.is_strict});
    scene::Scene scene = scene_of(asset, options);
    return {std::move(scene), asset.warnings(), asset.contents()};
}

} // namespace sr::gltf
