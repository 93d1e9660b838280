#include "support/generated.hpp"

#include "gltf/asset.hpp"
#include "support/gl.hpp"
#include "support/models.hpp"

#include <cstdlib>

namespace sr::testing {
namespace {

render::RenderOptions options_of(const Look& look) {
    render::RenderOptions options;
    options.width = options.height = look.size;
    options.samples = look.samples;
    options.seed = look.seed;
    options.estimator = look.estimator;
    options.estimates_error = look.estimates_error;
    options.maps.size = 128;
    return options;
}

std::uint64_t number_in(const char* variable, std::uint64_t otherwise) {
    const char* text = std::getenv(variable);
    return text ? std::strtoull(text, nullptr, 10) : otherwise;
}

} // namespace

Pictures::Pictures(const Look& look) : look_(look), shaders_(render::Renderer::programs(options_of(look))) {
    context();
}

image::Image Pictures::of(const scene::RenderScene& stage) { return of(stage, look_.samples, look_.seed); }

image::Image Pictures::of(const scene::RenderScene& stage, int samples, std::uint32_t seed) {
    const render::GpuScene gpu_scene(stage.scene, stage.lights, look_.visibility);
    render::RenderOptions options = options_of(look_);
    options.samples = samples;
    options.seed = seed;
    render::Renderer renderer(gpu_scene, stage.camera, options, shaders_);
    for (int i = 0; i < samples; ++i) renderer.add_sample();
    return renderer.read_film();
}

scene::Scene loaded(const MadeGltf& made, bool is_strict) {
    static const std::filesystem::path folder = scratch_folder("generated");
    const auto file = folder / "scene.gltf";
    write_text(file, made.gltf());
    gltf::LoadOptions options;
    options.is_strict = is_strict;
    return gltf::load(file, options).scene;
}

scene::RenderScene staged(scene::Scene scene) {
    scene::PrepareOptions options;
    options.rig = scene::Rig::none;
    options.aspect_ratio = 1.0f;
    return scene::prepare_scene(std::move(scene), "generated", options);
}

int scenes_of_a_recipe(int usual) {
    return static_cast<int>(number_in("STERADIAN_SCENES", static_cast<std::uint64_t>(usual)));
}

std::uint64_t first_seed() { return number_in("STERADIAN_SEED", 0); }

} // namespace sr::testing
