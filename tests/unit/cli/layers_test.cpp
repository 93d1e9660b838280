#include "output/channels.hpp"

#include "support/address.hpp"
#include "support/gl.hpp"
#include "support/scenes.hpp"

using namespace sr;
using namespace sr::testing;

namespace {

const std::vector<scene::Light> lights{
    scene::PointLight{"key", {0.2f, 1, 0}, vec3(1.0f, 2.0f, 3.0f)},
    scene::RectangleLight{"soft box", {0, 1, 0}, {0.3f, 0, 0}, {0, 0, 0.3f}, vec3(2.0f)},
    scene::RectangleLight{"key", {0.5f, 1, 0}, {0.3f, 0, 0}, {0, 0, 0.3f}, vec3(2.0f)},
    scene::DirectionalLight{"", {0, -1, 0}, vec3(0.5f), 0.01f}};

const Test names("unit.cli.layers.names_are_plain_and_differ", [] {
    EXPECT_EQ(output::layer_names(lights),
              (std::vector<std::string>{"emission", "key", "soft_box", "key_2", "light_3"}));
    EXPECT_EQ(output::layer_names(lights, {"soft_box"})[2], "soft_box_2");
});

// The picture is the sum of its layers, emission included.
const Test sum("unit.cli.layers.add_up_to_the_picture", [] {
    context();
    scene::Scene plane = lambert_plane(4.0f, vec3(0.5f, 0.6f, 0.7f));
    plane.materials[0].specular = 1.0f;
    plane.materials[0].emission = vec3(0.01f, 0.02f, 0.03f);
    const render::GpuScene scene(plane, lights);
    render::RenderOptions options;
    options.width = options.height = 24;
    options.samples = 8;
    render::Renderer renderer(scene, camera_from_above(1.0f), options);
    const auto add = [&](const std::string&) {
        for (int i = 0; i < options.samples; ++i) renderer.add_sample();
        return true;
    };
    add("");
    const image::Image film = renderer.read_film();
    const auto channels = output::render_layers(output::layer_names(lights), renderer, add);
    const image::Image image = output::with_channels(film, channels);
    ASSERT_EQ(image.channels, 4 + 3 * 5);
    EXPECT_EQ(image.channel_names[7], "key.R");
    for (int y = 0; y < film.height; ++y) {
        for (int x = 0; x < film.width; ++x) {
            for (std::size_t c = 0; c < 3; ++c) {
                float total = 0.0f;
                for (std::size_t layer = 0; layer < 5; ++layer) total += image.at(x, y)[4 + 3 * layer + c];
                ASSERT_EQ(image.at(x, y)[c], film.at(x, y)[c]);
                ASSERT_NEAR(total / film.at(x, y)[c], 1.0f, 3e-6f);
                EXPECT_GT(image.at(x, y)[4 + 3 + c], 0.0f);
            }
        }
    }
});

} // namespace
