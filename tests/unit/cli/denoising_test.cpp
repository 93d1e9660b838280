#include "output/denoise.hpp"

#include "support/address.hpp"
#include "support/gl.hpp"
#include "support/scenes.hpp"

#include <cmath>

using namespace sr;
using namespace sr::testing;

namespace {

constexpr int denoised_size = 48;

/// A sheet that throws its shadow on a plane, itself out of the picture.
struct Shade {
    scene::Scene scene = lambert_plane(2.0f);
    std::vector<scene::Light> lights;

    explicit Shade(scene::Light lamp) : lights{std::move(lamp)} {
        add_quad(scene, {1.5f, 0.6f, 0}, {0.35f, 0, 0.1f}, {0.1f, 0, -0.35f}, lambert());
    }
};

struct Films {
    image::Image plain;
    image::Image denoised;
};

Films films_of(const Shade& shade, int samples, bool denoises) {
    context();
    const render::GpuScene scene(shade.scene, shade.lights);
    const scene::Camera camera = camera_from_above(1.03f);
    render::RenderOptions options;
    options.width = options.height = denoised_size;
    options.samples = samples;
    options.estimator = render::Estimator::analytic;
    options.estimates_error = true;
    render::Renderer renderer(scene, camera, options);
    for (int i = 0; i < samples; ++i) renderer.add_sample();
    Films films{renderer.read_film(), {}};
    if (denoises)
        films.denoised =
            output::denoise(renderer, {scene, camera, options, renderer.pixel_samples(), {}}, {});
    return films;
}

double mean_square(const image::Image& a, const image::Image& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) sum += std::pow(a.pixels[i] - b.pixels[i], 2.0);
    return sum / static_cast<double>(a.pixels.size());
}

// A penumbra of few samples comes nearer to one of many.
const Test penumbra("unit.cli.denoising.a_penumbra_gains", [] {
    const Shade shade(scene::RectangleLight{"", {3.0f, 1.5f, 0}, {0.4f, 0, 0}, {0, 0, 0.4f}, vec3(5.0f)});
    const image::Image truth = films_of(shade, 128, false).plain;
    const Films films = films_of(shade, 8, true);
    const double before = mean_square(films.plain, truth), after = mean_square(films.denoised, truth);
    EXPECT_LT(after, 0.5 * before);
    EXPECT_GT(before, 0.0);
});

// A sharp shadow has no noise but on its very edge: everything else stays as it is.
const Test edge("unit.cli.denoising.sharp_shadows_stay_sharp", [] {
    const Films films = films_of(Shade(scene::PointLight{"", {3.0f, 1.5f, 0}, vec3(5.0f)}), 8, true);
    int changed = 0, dark = 0;
    for (std::size_t i = 0; i < films.plain.pixels.size(); i += 4) {
        changed += std::abs(films.plain.pixels[i] - films.denoised.pixels[i]) > 1e-5f;
        dark += films.denoised.pixels[i] == 0.0f;
    }
    EXPECT_LT(changed, 8 * denoised_size) << "of " << denoised_size * denoised_size;
    EXPECT_GT(dark, 2 * denoised_size);
});

} // namespace
