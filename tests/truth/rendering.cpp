#include "truth/rendering.hpp"

#include "core/error.hpp"
#include "image/file.hpp"
#include "render/renderer.hpp"
#include "scene/emitters.hpp"
#include "support/gl.hpp"
#include "support/models.hpp"
#include "truth/scenes.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace sr::truth {
namespace {

constexpr int enlargement = 4;
constexpr int sets = 4;
constexpr int samples_per_set = 64;

} // namespace

Measured rendered(std::string_view shape, std::string_view material, std::string_view view) {
    sr::testing::context();
    scene::Scene scene = scene_of(shape, material, view);
    const std::vector<scene::Light> lights = scene::emitters_of(scene);
    scene.instances.resize(1); // the camera looks past the emitter: only the receiver is drawn
    const render::GpuScene gpu_scene(scene, lights, render::Visibility::none); // nothing could hide anything
    render::RenderOptions options;
    options.width = options.height = enlargement * cell_size;
    options.samples = samples_per_set;
    std::vector<image::Image> pictures;
    for (int set = 0; set < sets; ++set) {
        options.seed = static_cast<std::uint32_t>(set);
        render::Renderer renderer(gpu_scene, camera_of(view), options);
        for (int i = 0; i < samples_per_set; ++i) renderer.add_sample();
        pictures.push_back(renderer.film());
    }
    return measured(pictures, enlargement);
}

Measured stored(std::string_view shape, std::string_view material, std::string_view view) {
    const auto file =
        sr::testing::source_folder() / "tests/truth/references" / fmt::format("{}.{}.exr", shape, view);
    const image::Image atlas = image::read(file);
    require(atlas.channels == 6 && atlas.height == cell_size, "an atlas has R G B and their noise");
    const auto column = std::ranges::find(materials, material) - materials.begin();
    Measured result{image::Image(cell_size, cell_size, 3), image::Image(cell_size, cell_size, 3)};
    const auto channel = [&](const std::string& name) {
        const auto place = std::ranges::find(atlas.channel_names, name);
        require(place != atlas.channel_names.end(), "the atlas has the channel");
        return static_cast<std::size_t>(place - atlas.channel_names.begin());
    };
    const std::array<std::string, 3> names{"R", "G", "B"};
    for (std::size_t c = 0; c < 3; ++c) {
        const std::size_t mean = channel(names[c]), noise = channel("noise." + names[c]);
        for (int y = 0; y < cell_size; ++y) {
            for (int x = 0; x < cell_size; ++x) {
                const auto texel = atlas.at(static_cast<int>(column) * cell_size + x, y);
                result.mean.at(x, y)[c] = texel[mean];
                result.noise.at(x, y)[c] = texel[noise];
            }
        }
    }
    return result;
}

} // namespace sr::truth
