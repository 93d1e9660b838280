// The points of samples, in pictures.
#include "support/address.hpp"
#include "support/gl.hpp"
#include "support/scenes.hpp"

using namespace sr;
using namespace sr::testing;

namespace {

constexpr int edge = 24; // of a picture [pixels]

/// A plane in the half shadows of a tilted square, whose back the camera does not see: no other edge is in
/// the picture.
scene::Scene shadow_on_plane() {
    auto scene = lambert_plane(3.0f, vec3(0.7f));
    add_quad(scene, {0.1f, 0.3f, -0.1f}, {0.5f, 0, 0.2f}, {-0.2f, 0, 0.5f}, lambert(vec3(0.5f)));
    return scene;
}

const std::vector<scene::Light> two_squares{
    scene::RectangleLight{"", {1.5f, 1.6f, 0.5f}, {0, 0, 0.4f}, {0.4f, 0.1f, 0}, vec3(5.0f)},
    scene::RectangleLight{"", {-1.2f, 1.4f, 1.0f}, {0.3f, 0, 0.1f}, {0, 0.1f, 0.3f}, vec3(4.0f)}};

image::Image film_of(const render::GpuScene& scene, const glsl::Root& root, render::LightSampling sampling,
                     int samples, std::uint32_t seed) {
    render::RenderOptions options;
    options.width = options.height = edge;
    options.samples = samples;
    options.seed = seed;
    options.lights = sampling;
    options.shader_path.insert(options.shader_path.begin(), root);
    render::Renderer renderer(scene, camera_from_above(1.6f), options);
    for (int i = 0; i < samples; ++i) renderer.add_sample();
    return renderer.read_film();
}

double mean_square(const image::Image& a, const image::Image& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.pixels.size(); i += 4) {
        const double difference = static_cast<double>(a.pixels[i]) - static_cast<double>(b.pixels[i]);
        sum += difference * difference;
    }
    return sum / (edge * edge);
}

/// A file that gives each pixel and purpose a sequence of its own, as if it were independent of where samples
/// look.
const glsl::Root apart = glsl::Root::memory("apart", {{"integrator/random_point.glsl", R"(
#include "base/sampling.glsl"
#include "interface/frame.glsl"
vec2 random_point(uint purpose) {
    uvec2 pixel = uvec2(gl_FragCoord.xy);
    return sobol_2d(sample_index, hash(pixel.x, hash(pixel.y, hash(purpose, seed))));
}
vec2 further_random_point(uint purpose) { return random_point(purpose); }
)"}});

// Points on lights that are spread together with the places in a pixel have the same mean, and less error.
const Test together("law.sampling.points_on_lights_are_spread_over_the_pixel", [] {
    context();
    const render::GpuScene scene(shadow_on_plane(), two_squares, render::Visibility::ray_on_cpu);
    const glsl::Root nothing = glsl::Root::memory("nothing", {});
    const image::Image reference = film_of(scene, apart, render::LightSampling::all, 2048, 99);
    for (const auto sampling : {render::LightSampling::all, render::LightSampling::one}) {
        double joint = 0.0, padded = 0.0;
        for (const std::uint32_t seed : {1u, 2u}) {
            joint += mean_square(film_of(scene, nothing, sampling, 128, seed), reference);
            padded += mean_square(film_of(scene, apart, sampling, 128, seed), reference);
        }
        EXPECT_LT(joint, 0.7 * padded);
    }
});

} // namespace
