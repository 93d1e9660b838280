#include "truth/rendering.hpp"

#include "core/error.hpp"
#include "image/file.hpp"
#include "render/renderer.hpp"
#include "scene/prepare.hpp"
#include "support/gl.hpp"
#include "support/models.hpp"
#include "truth/ball_scenes.hpp"
#include "truth/scenes.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace sr::truth {
namespace {

/// The picture is drawn larger, which gives the same box-filtered pixels in fewer frames.
struct Samples {
    int enlargement = 4;
    int sets = 4; // independent ones, from which noise is known
    int per_set = 64;
};

std::vector<image::Image> sets_of(const render::GpuScene& scene, const scene::Camera& camera, int size,
                                  const Samples& samples) {
    render::RenderOptions options;
    options.width = options.height = samples.enlargement * size;
    options.samples = samples.per_set;
    std::vector<image::Image> pictures;
    for (int set = 0; set < samples.sets; ++set) {
        options.seed = static_cast<std::uint32_t>(set);
        render::Renderer renderer(scene, camera, options);
        for (int i = 0; i < samples.per_set; ++i) renderer.add_sample();
        pictures.push_back(renderer.read_film());
    }
    return pictures;
}

/// The square of that number in a file of tests/truth/references/.
Measured stored(const std::string& name, std::ptrdiff_t column, int size) {
    const auto file = sr::testing::source_folder() / "tests/truth/references" / (name + ".exr");
    const image::Image atlas = image::read(file);
    require(atlas.channels == 6 && atlas.height == size, "an atlas has R G B and their noise");
    Measured result{image::Image(size, size, 3), image::Image(size, size, 3)};
    const auto channel = [&](const std::string& title) {
        const auto place = std::ranges::find(atlas.channel_names, title);
        require(place != atlas.channel_names.end(), "the atlas has the channel");
        return static_cast<std::size_t>(place - atlas.channel_names.begin());
    };
    const std::array<std::string, 3> names{"R", "G", "B"};
    for (std::size_t c = 0; c < 3; ++c) {
        const std::size_t mean = channel(names[c]), noise = channel("noise." + names[c]);
        for (int y = 0; y < size; ++y) {
            for (int x = 0; x < size; ++x) {
                const auto texel = atlas.at(static_cast<int>(column) * size + x, y);
                result.mean.at(x, y)[c] = texel[mean];
                result.noise.at(x, y)[c] = texel[noise];
            }
        }
    }
    return result;
}

} // namespace

Measured rendered(std::string_view shape, std::string_view material, std::string_view view) {
    sr::testing::context();
    scene::Scene scene = scene_of(shape, material, view);
    const std::vector<scene::Light> lights = scene::emitters_of(scene);
    scene.instances.resize(1); // the camera looks past the emitter: only the receiver is drawn
    const render::GpuScene gpu_scene(scene, lights, render::Visibility::none); // nothing could hide anything
    Samples samples;
    if (shape == "textured_rectangle") samples.sets = 6; // four have the noise that truth_test.cpp allows
    return measured(sets_of(gpu_scene, camera_of(view), cell_size, samples), samples.enlargement);
}

Measured stored(std::string_view shape, std::string_view material, std::string_view view) {
    if (material == photograph) return stored(fmt::format("{}.{}", photograph, view), 0, cell_size);
    return stored(fmt::format("{}.{}", shape, view),
                  std::ranges::find(materials, material) - materials.begin(), cell_size);
}

Measured rendered_ball(std::string_view brdf, std::string_view light) {
    sr::testing::context();
    const scene::Scene scene = ball_scene(brdf, light);
    const render::GpuScene gpu_scene(scene, scene.lights, render::Visibility::ray);
    // All pixels of a frame share the place within the pixel, which is most of the noise under a point: few
    // large pixels are as good there, and sets have to differ by whole pixels.
    const Samples samples{2, 8,
                          light == "environment" ? 16 : 8}; // half of an environment is below the horizon
    std::vector<image::Image> sets = sets_of(gpu_scene, ball_camera(), ball_size, samples);
    for (image::Image& set : sets) set = reduced(set, samples.enlargement);
    return with_shared_noise(measured(sets, 1));
}

Measured stored_ball(std::string_view brdf, std::string_view light) {
    std::ptrdiff_t column = 0;
    for (const auto other : ball_brdfs) {
        if (other == brdf) break;
        column += is_lit(other, light);
    }
    return stored(fmt::format("balls.{}", light), column, ball_size);
}

} // namespace sr::truth
