#include "render/adaptive/error_estimate.hpp"

#include "render/adaptive/converged_pixels.hpp"
#include "support/address.hpp"
#include "support/gl.hpp"
#include "support/scenes.hpp"

#include <cmath>
#include <random>

using namespace sr;
using namespace sr::testing;

namespace {

/// The means of a picture of value 2 and coverage 1, and of its first half, where each sample has the
/// standard deviation `noise`.
struct Noisy {
    image::Image mean{64, 64, 4};
    image::Image first{64, 64, 4};
};

Noisy noisy(int samples, float noise) {
    Noisy picture;
    std::mt19937 random(7);
    const int n_first = (samples + 1) / 2, n_second = samples / 2;
    std::normal_distribution<float> first(0, noise / std::sqrt(static_cast<float>(n_first)));
    std::normal_distribution<float> second(0, noise / std::sqrt(static_cast<float>(n_second)));
    for (std::size_t i = 0; i < picture.mean.pixels.size(); ++i) {
        const bool is_color = i % 4 < 3;
        const float a = is_color ? 2 + first(random) : 1, b = is_color ? 2 + second(random) : 1;
        picture.first.pixels[i] = a;
        picture.mean.pixels[i] = (static_cast<float>(n_first) * a + static_cast<float>(n_second) * b)
                                 / static_cast<float>(samples);
    }
    return picture;
}

// Known noise is found, with an odd number of samples as well: σ/√n relative to 2, in three of four channels.
const Test known("unit.render.error_estimate.finds_known_noise", [] {
    for (const int samples : {2, 3, 15, 64}) {
        const Noisy picture = noisy(samples, 0.2f);
        const auto estimate =
            render::estimate_error(picture.mean, picture.first, std::vector<int>(64 * 64, samples));
        const double truth = 0.1 / std::sqrt(samples) * std::sqrt(0.75);
        EXPECT_NEAR(estimate.expected / truth, 1.0, 0.05) << samples;
        EXPECT_GT(estimate.error, estimate.expected);
        EXPECT_LT(estimate.error, 1.2 * estimate.expected);
        EXPECT_NEAR(estimate.floor, 0.02, 1e-3);
    }
});

const Test none("unit.render.error_estimate.equal_halves_have_none", [] {
    const Noisy picture = noisy(8, 0.0f);
    const auto estimate = render::estimate_error(picture.mean, picture.first, std::vector<int>(64 * 64, 8));
    EXPECT_EQ(estimate.error, 0.0);
});

// A firefly in one half does not excuse itself by making its pixel bright.
const Test firefly("unit.render.error_estimate.a_firefly_counts", [] {
    Noisy picture = noisy(8, 0.0f);
    picture.first.at(9, 9)[0] = 402.0f;
    picture.mean.at(9, 9)[0] = 202.0f; // 2 and 402
    const auto estimate = render::estimate_error(picture.mean, picture.first, std::vector<int>(64 * 64, 8));
    EXPECT_GT(estimate.squares[9 * 64 + 9], 3.0f);
    EXPECT_GT(estimate.error, estimate.expected);
});

const std::vector<scene::Light> lamp{
    scene::RectangleLight{"", {0.0f, 1.5f, 0.0f}, {0.3f, 0, 0}, {0, 0, 0.3f}, vec3(10.0f)}};

render::PixelMask left_half(int size) {
    render::PixelMask mask;
    for (int i = 0; i < size * size; ++i) mask.push_back(i % size < size / 2 ? 1 : 0);
    return mask;
}

// A pixel that rests has the very samples that a shorter rendering has, one that works those of a longer one;
// and repeat() takes all of them again. With shadows, so that the rays' bands follow.
const Test rest("unit.render.frozen.pixels_keep_their_samples", [] {
    context();
    constexpr int size = 32;
    scene::Scene plane = lambert_plane(4.0f);
    add_quad(plane, {0, 0.5f, 0}, {0.3f, 0, 0}, {0, 0, -0.3f}, lambert());
    const render::GpuScene scene(plane, lamp);
    render::RenderOptions options;
    options.width = options.height = size;
    options.estimates_error = true;
    render::Renderer whole(scene, camera_from_above(1.0f), options),
        other(scene, camera_from_above(1.0f), options);
    const auto add = [](render::Renderer& renderer, int count) {
        for (int i = 0; i < count; ++i) renderer.add_sample();
        return renderer.read_film();
    };
    const image::Image at_5 = add(whole, 5), at_12 = add(whole, 7);
    add(other, 5);
    other.freeze(left_half(size));
    for (const image::Image& film : {add(other, 7), (other.repeat(), add(other, 12))}) {
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x)
                for (std::size_t c = 0; c < 4; ++c)
                    ASSERT_EQ(film.at(x, y)[c], (x < size / 2 ? at_5 : at_12).at(x, y)[c]) << x << ' ' << y;
    }
    EXPECT_EQ(other.pixel_samples()[size / 2 - 1], 5);
    EXPECT_EQ(other.pixel_samples()[size / 2], 12);
    other.freeze(render::PixelMask(size * size, 1));
    EXPECT_TRUE(other.is_frozen());
    other.clear();
    EXPECT_FALSE(other.is_frozen());
});

} // namespace
