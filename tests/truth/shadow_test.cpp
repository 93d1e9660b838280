#include "compare/compare.hpp"
#include "image/file.hpp"
#include "render/renderer.hpp"
#include "scene/prepare.hpp"
#include "support/address.hpp"
#include "support/gl.hpp"
#include "support/models.hpp"
#include "truth/shadow_scenes.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

using namespace sr;
using namespace sr::testing;

namespace {

struct How {
    render::Estimator estimator = render::Estimator::sampled;
    int samples = 1;
    int size = truth::shadow_picture_size;
    render::Visibility visibility = render::Visibility::ray;
};

image::Image rendered(std::string_view name, const How& how) {
    context();
    truth::ShadowScene made = truth::shadow_scene(name);
    scene::RenderScene stage =
        scene::prepare_scene(std::move(made.scene), std::string(name), {"", scene::Rig::none, 1.0f});
    const render::GpuScene gpu_scene(stage.scene, stage.lights, how.visibility);
    render::RenderOptions options;
    options.width = options.height = how.size;
    options.samples = how.samples;
    options.estimator = how.estimator;
    options.analytic_points = 4; // where lobes are wide; truth tests of `sampled` judge their shape
    render::Renderer renderer(gpu_scene, made.camera, options);
    for (int i = 0; i < how.samples; ++i) renderer.add_sample();
    return renderer.read_film();
}

/// Three channels of `image` whose names begin with `prefix`.
image::Image layer(const image::Image& image, const std::string& prefix) {
    image::Image result(image.width, image.height, 3);
    const std::array<std::string, 3> names{"R", "G", "B"};
    for (std::size_t c = 0; c < 3; ++c) {
        const auto name = prefix + names[c];
        const auto place = std::ranges::find(image.channel_names, name) - image.channel_names.begin();
        for (std::size_t i = 0; i < result.pixels.size() / 3; ++i)
            result.pixels[3 * i + c] =
                image.pixels[i * static_cast<std::size_t>(image.channels) + static_cast<std::size_t>(place)];
    }
    return result;
}

image::Image without_alpha(const image::Image& film) {
    image::Image result(film.width, film.height, 3);
    for (std::size_t i = 0; i < result.pixels.size(); ++i) result.pixels[i] = film.pixels[i / 3 * 4 + i % 3];
    return result;
}

/// The means of 2×2 pixels.
image::Image halved(const image::Image& image) {
    image::Image result(image.width / 2, image.height / 2, image.channels);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            for (std::size_t c = 0; c < static_cast<std::size_t>(image.channels); ++c)
                result.at(x / 2, y / 2)[c] += 0.25f * image.at(x, y)[c];
    return result;
}

/// relMSE that 1024 samples of the reference's program are expected to cost: its sixteenth of 16,384 samples.
double noise_floor(const image::Image& reference, const image::Image& noise, double floor) {
    double sum = 0.0;
    for (std::size_t i = 0; i < noise.pixels.size(); ++i)
        sum += std::pow(noise.pixels[i], 2.0) / (std::pow(reference.pixels[i], 2.0) + floor * floor);
    return 16.0 * sum / static_cast<double>(noise.pixels.size()); // mean σ² / (r² + floor²)
}

struct Distance {
    compare::Metrics metrics;
    double noise_floor = 0.0;
};

Distance distance(std::string_view name, const How& how) {
    const image::Image stored =
        image::read(source_folder() / "tests/truth/references" / fmt::format("shadow.{}.exr", name));
    image::Image reference = layer(stored, "");
    const image::Image noise = layer(stored, "noise.");
    const image::Image ours = without_alpha(rendered(name, how));
    if (how.size < reference.width) return {compare::compare(ours, halved(reference)).metrics};
    const compare::Metrics metrics = compare::compare(ours, reference).metrics;
    return {metrics, noise_floor(reference, noise, metrics.floor)};
}

/// One line of tests/truth/README.md's table.
void print(std::string_view name, std::string_view estimator, const Distance& d) {
    double energy = 0.0;
    for (const double ratio : d.metrics.energy_ratio) energy = std::max(energy, std::abs(ratio - 1.0));
    const auto noise = d.noise_floor > 0.0 ? fmt::format("{:.1f}", d.metrics.rel_mse / d.noise_floor) : "";
    fmt::print("| {} | {} | {:.3f} | {:.1e} | {} | {:.4f} |\n", name, estimator, 100.0 * energy,
               d.metrics.rel_mse, noise, d.metrics.flip);
}

void expect_sampled(std::string_view name, int samples) {
    const Distance d = distance(name, {.samples = samples});
    print(name, "sampled", d);
    for (const double ratio : d.metrics.energy_ratio) EXPECT_NEAR(ratio, 1.0, 0.003);
    EXPECT_LE(d.metrics.rel_mse, 3.0 * d.noise_floor);
}

/// Depth maps are held to the doubled bars.
void expect_mapped(std::string_view name, int samples) {
    const Distance d = distance(name, {.samples = samples, .visibility = render::Visibility::map});
    print(name, "sampled, map", d);
    for (const double ratio : d.metrics.energy_ratio) EXPECT_NEAR(ratio, 1.0, 0.006);
    EXPECT_LE(d.metrics.rel_mse, 6.0 * d.noise_floor);
}

void expect_analytic(std::string_view name, int samples) {
    const Distance d = distance(name, {render::Estimator::analytic, samples, truth::shadow_picture_size / 2});
    print(name, "analytic", d);
    EXPECT_LE(d.metrics.flip, 0.02); // of pictures of half the size, whose pixels are the means of four
}

const Test cornell("truth.shadow.cornell", [] { expect_sampled("cornell", 192); });
const Test veach("truth.shadow.veach", [] { expect_sampled("veach", 128); });
const Test zoo("truth.shadow.zoo", [] { expect_sampled("zoo", 256); });
const Test fence("truth.shadow.fence", [] { expect_sampled("fence", 96); });
const Test mesh("truth.shadow.mesh", [] { expect_sampled("mesh", 128); });
const Test ball("truth.shadow.ball", [] { expect_sampled("ball", 96); });

// The other scenes take a minute; tests/truth/README.md has what they give.
const Test cornell_map("truth.shadow.cornell_map", [] { expect_mapped("cornell", 48); });
const Test fence_map("truth.shadow.fence_map", [] { expect_mapped("fence", 32); });
const Test ball_map("truth.shadow.ball_map", [] { expect_mapped("ball", 48); });

const Test cornell_analytic("truth.shadow.cornell_analytic", [] { expect_analytic("cornell", 24); });
const Test veach_analytic("truth.shadow.veach_analytic", [] { expect_analytic("veach", 24); });
const Test zoo_analytic("truth.shadow.zoo_analytic", [] { expect_analytic("zoo", 16); });
const Test fence_analytic("truth.shadow.fence_analytic", [] { expect_analytic("fence", 96); });
const Test mesh_analytic("truth.shadow.mesh_analytic", [] { expect_analytic("mesh", 16); });
const Test ball_analytic("truth.shadow.ball_analytic", [] { expect_analytic("ball", 16); });

} // namespace
