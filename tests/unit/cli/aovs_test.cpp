#include "output/channels.hpp"

#include "support/address.hpp"
#include "support/gl.hpp"
#include "support/scenes.hpp"

#include <cmath>
#include <map>

using namespace sr;
using namespace sr::testing;

namespace {

const Test list("unit.cli.aovs.a_list_is_read_or_refused", [] {
    EXPECT_EQ(output::parse_aovs("object,depth"),
              (output::Variables{output::aov_named("object"), output::aov_named("depth")}));
    for (const char* wrong : {"", "deep", "depth,", "depth,depth", "depth, normal"})
        EXPECT_FALSE(output::parse_aovs(wrong)) << wrong;
    for (const std::string& name : output::aov_names()) EXPECT_TRUE(output::parse_aovs(name)) << name;
});

/// A plane with a small square above its middle, under a point light.
struct Table {
    scene::Scene scene = lambert_plane(4.0f, vec3(0.25f, 0.5f, 0.75f));
    std::vector<scene::Light> lights{scene::PointLight{"", {0, 2, 0}, vec3(9.0f)}};

    Table() {
        add_quad(scene, {0, 1, 0}, {0.4f, 0, 0}, {0, 0, -0.4f}, lambert());
        scene.instances.back().name = "square \"of\" 40 cm";
    }
};

constexpr int size = 33, middle = size / 2;

/// Renders the channels of all AOVs but those that a picture counts itself, by name.
std::map<std::string, std::vector<float>> rendered_channels(const Table& table, const scene::Camera& camera) {
    context();
    const render::GpuScene scene(table.scene, table.lights);
    render::RenderOptions options;
    options.width = options.height = size;
    const output::AovSource source{scene, camera, options, std::vector<int>(size * size, 4), {}};
    std::map<std::string, std::vector<float>> channels;
    for (output::ImageChannel& channel : output::render_aovs(
             *output::parse_aovs("depth,normal,albedo,visibility,irradiance,object,material"), source, {}))
        channels[channel.name] = std::move(channel.values);
    return channels;
}

// Each is what its documentation says, in its unit, at a pixel of the square, of the plane, of its shadow and
// beyond.
const Test values("unit.cli.aovs.have_their_units", [] {
    const Table table;
    auto channels = rendered_channels(table, camera_from_above(5.0f));
    const auto at = [&](const char* name, int column) { return channels.at(name)[middle * size + column]; };
    const int on_square = middle, in_shadow = middle - 2, lit = middle + 6, beyond = 0;
    const float x = place_of(lit, middle, size, 5.0f).x;
    const float E = 9.0f * 2.0f / std::pow(4.0f + x * x, 1.5f); // I cosθ / d², cosθ = 2/d
    EXPECT_NEAR(at("irradiance.G", lit), E, 0.01f * E);
    EXPECT_NEAR(at("irradiance.R", on_square), 9.0f, 0.3f);
    EXPECT_EQ(at("visibility.V", lit), 1.0f);
    EXPECT_EQ(at("visibility.V", in_shadow), 0.0f);
    EXPECT_EQ(at("irradiance.R", in_shadow), 0.0f);
    EXPECT_NEAR(at("depth.Z", lit) - at("depth.Z", on_square), 1.0f, 1e-4f);
    EXPECT_EQ(at("depth.Z", beyond), 0.0f);
    EXPECT_NEAR(at("normal.Y", lit), 1.0f, 1e-6f);
    EXPECT_NEAR(at("albedo.B", lit), 0.75f, 1e-6f);
    EXPECT_EQ(at("object.id", lit), 0.0f);
    EXPECT_EQ(at("object.id", on_square), 1.0f);
    EXPECT_EQ(at("material.id", on_square), 1.0f);
    EXPECT_EQ(at("object.id", beyond), -1.0f);
    const auto tables = output::name_tables({output::aov_named("object")}, table.scene);
    ASSERT_EQ(tables.size(), 1u);
    EXPECT_EQ(tables[0].value, R"(["plane","square \"of\" 40 cm"])");
});

// Depth goes along the axis: a plane across it is at one depth, also at the corners, for both kinds of
// camera.
const Test depth("unit.cli.aovs.depth_is_along_the_axis", [] {
    Table table;
    table.scene.instances.pop_back();
    for (const bool is_perspective : {true, false}) {
        scene::Camera camera = camera_from_above(1.0f);
        camera.world_from_camera[3] = vec4(0, 2.5f, 0, 1);
        if (is_perspective)
            camera.projection = scene::Perspective{1.0f, 1.0f, 0.01f, {}};
        else
            camera.projection = scene::Orthographic{1.0f, 1.0f, 0.5f, 10.0f};
        const auto channels = rendered_channels(table, camera);
        for (const float z : channels.at("depth.Z")) ASSERT_NEAR(z, 2.5f, 1e-4f) << is_perspective;
    }
});

} // namespace
