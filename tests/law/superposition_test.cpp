#include "support/address.hpp"
#include "support/scenes.hpp"

using namespace sr;
using namespace sr::testing;

namespace {

const std::vector<scene::Light> zoo{
    scene::PointLight{"", {-1.0f, 1.0f, 0.0f}, vec3(3.0f, 1.0f, 0.5f)},
    scene::SpotLight{"", {1.0f, 2.0f, 0.5f}, {0.0f, -1.0f, 0.0f}, vec3(0.2f, 5.0f, 1.0f)},
    scene::DirectionalLight{"", glm::normalize(vec3(1.0f, -1.0f, 0.3f)), vec3(0.7f)},
};

// Light is linear: the picture under all lights is the sum of the pictures under each, to float rounding.
const Test superposition("law.integrator.superposition", [] {
    auto plane = lambert_plane(4.0f, vec3(0.8f, 0.5f, 0.2f));
    plane.materials[0].specular = 1.0f;
    plane.materials[0].roughness = 0.4f;
    const auto camera = camera_from_above(2.0f);
    const auto together = picture(plane, zoo, camera, 64);
    image::Image sum(64, 64, 4);
    for (const scene::Light& light : zoo) {
        const auto alone = picture(plane, std::span(&light, 1), camera, 64);
        for (std::size_t i = 0; i < sum.pixels.size(); ++i) sum.pixels[i] += alone.pixels[i];
    }
    EXPECT_LT(max_relative_difference(together, sum, 1e-3f), 1e-6f);
});

// Twice the light is twice the radiance, to the last bit: a power of two does not round.
const Test linear("law.integrator.linear_in_the_light", [] {
    const auto plane = lambert_plane(4.0f, vec3(0.8f, 0.5f, 0.2f));
    const auto camera = camera_from_above(2.0f);
    const std::vector<scene::Light> once{scene::PointLight{"", {0.0f, 1.0f, 0.0f}, vec3(3.0f)}};
    const std::vector<scene::Light> twice{scene::PointLight{"", {0.0f, 1.0f, 0.0f}, vec3(6.0f)}};
    const auto a = picture(plane, once, camera, 64);
    const auto b = picture(plane, twice, camera, 64);
    for (std::size_t i = 0; i < a.pixels.size(); ++i)
        ASSERT_EQ(i % 4 == 3 ? a.pixels[i] : 2.0f * a.pixels[i], b.pixels[i]);
});

// A surface that no emitter reaches is black: there is no ambient term.
const Test darkness("law.integrator.no_light_is_black", [] {
    const auto image = picture(lambert_plane(4.0f), {}, camera_from_above(2.0f), 16);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        EXPECT_EQ(image.pixels[i], i % 4 == 3 ? 1.0f : 0.0f);
});

} // namespace
