#include "image/image.hpp"
#include "render/adaptive/convergence.hpp"
#include "support/address.hpp"
#include "support/gl.hpp"
#include "support/scenes.hpp"

#include <cmath>

using namespace sr;
using namespace sr::testing;

namespace {

constexpr int size = 48;
constexpr float half_extent = 1.57f; // the plane ends at 1, and around it nothing is to be done

/// A glossy plane, a box over it and a small bright sheet in sight: a penumbra, a highlight, edges, and
/// pixels that few samples find.
scene::Scene still_life() {
    scene::Scene scene = lambert_plane(1.0f, vec3(0.5f, 0.3f, 0.2f));
    scene.materials[0].specular = 1.0f;
    scene.materials[0].roughness = 0.4f;
    add_box(scene, {0.2f, 0.2f, 0.1f}, mat3(0.2f), 1, lambert());
    scene::Material glowing = lambert(vec3(0.0f));
    glowing.emission = vec3(50.0f);
    add_quad(scene, {-0.55f, 0.01f, -0.3f}, {0.08f, 0, 0.03f}, {0.03f, 0, -0.08f}, glowing);
    return scene;
}

const std::vector<scene::Light> lamps{
    scene::RectangleLight{"", {0.3f, 1.2f, 0.0f}, {0.4f, 0, 0}, {0, 0, 0.4f}, vec3(4.0f, 3.0f, 2.0f)},
    scene::SphereLight{"", {-1.0f, 0.5f, 0.8f}, 0.1f, vec3(20.0f)}};

render::RenderOptions options(std::uint32_t seed) {
    render::RenderOptions options;
    options.width = options.height = size;
    options.seed = seed;
    return options;
}

/// relMSE as `steradian compare` has it, of all four channels.
double rel_mse(const image::Image& test, const image::Image& reference) {
    std::vector<float> colors;
    for (std::size_t i = 0; i < reference.pixels.size(); ++i)
        if (i % 4 < 3) colors.push_back(reference.pixels[i]);
    const double floor = image::relative_floor(colors);
    double sum = 0.0;
    for (std::size_t i = 0; i < test.pixels.size(); ++i) {
        const double d = static_cast<double>(test.pixels[i]) - reference.pixels[i];
        sum += i % 4 == 3 ? d * d : image::relative_square(d, reference.pixels[i], floor);
    }
    return sum / static_cast<double>(test.pixels.size());
}

struct Stopped {
    double true_error = 0.0;
    double estimate = 0.0;
    double samples = 0.0; // mean
    int most = 0;
};

Stopped stopped_at(double target, std::uint32_t seed, const render::GpuScene& scene,
                   const image::Image& reference) {
    render::RenderOptions halved = options(seed);
    halved.estimates_error = true;
    render::Renderer renderer(scene, camera_from_above(half_extent), halved);
    render::Convergence convergence(target);
    while (!convergence.is_reached() && renderer.sample_count() < 4096) {
        renderer.add_sample();
        if (render::is_estimate_due(renderer.sample_count())) convergence.update(renderer);
    }
    double samples = 0.0;
    for (const int count : renderer.pixel_samples()) samples += count;
    return {std::sqrt(rel_mse(renderer.read_film(), reference)), convergence.error(), samples / (size * size),
            renderer.sample_count()};
}

// A picture that stops at an error has no more of it, nine times in ten; it did not get there by far too many
// samples; and where many are taken, pixels that need few take few.
const Test word("law.stopping.an_error_keeps_its_word", [] {
    context();
    const render::GpuScene scene(still_life(), lamps);
    render::Renderer renderer(scene, camera_from_above(half_extent), options(12345));
    for (int i = 0; i < 4096; ++i) renderer.add_sample();
    const image::Image reference = renderer.read_film();
    int kept = 0, all = 0;
    for (const double target : {0.1, 0.03}) {
        double sum_of_ratios = 0.0, sum_of_shares = 0.0;
        for (std::uint32_t seed = 0; seed < 10; ++seed) {
            const Stopped stopped = stopped_at(target, seed, scene, reference);
            EXPECT_LE(stopped.estimate, target);
            sum_of_shares += stopped.samples / stopped.most;
            kept += stopped.true_error <= target;
            sum_of_ratios += stopped.true_error / target;
            ++all;
        }
        EXPECT_GT(sum_of_ratios / 10.0, 0.3) << "too careful";
        if (target < 0.05) {
            EXPECT_LT(sum_of_shares / 10.0, 0.8) << "of the most that any pixel took";
        }
        ::testing::Test::RecordProperty("true_over_target_at_"
                                            + std::to_string(static_cast<int>(100 * target)) + "_percent",
                                        std::to_string(sum_of_ratios / 10.0));
    }
    EXPECT_GE(kept, 0.9 * all) << "of " << all;
});

} // namespace
