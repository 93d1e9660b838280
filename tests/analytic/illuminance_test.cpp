#include "irradiance.hpp"
#include "output/illuminance.hpp"
#include "output/isolines.hpp"
#include "support/address.hpp"
#include "support/gl.hpp"
#include "support/scenes.hpp"

#include <cmath>
#include <numbers>

using namespace sr;
using namespace sr::testing;

namespace {

/// E on a receiver in a scene, columns × rows cells of `samples` samples.
output::IlluminanceGrid measured(scene::Scene scene, const std::vector<scene::Light>& lights,
                                 const scene::Receiver& receiver, int columns, int rows, int samples) {
    context();
    const scene::Camera camera = scene::add_receiver(scene, receiver);
    const render::GpuScene gpu_scene(scene, lights);
    render::RenderOptions options;
    options.width = columns;
    options.height = rows;
    options.samples = samples;
    options.shader = "views/irradiance.frag";
    render::Renderer renderer(gpu_scene, camera, options);
    for (int i = 0; i < samples; ++i) renderer.add_sample();
    return output::illuminance_of(renderer.read_film(), receiver);
}

constexpr scene::Receiver desk{{-2.0f, 0.8f, 1.5f}, {4.0f, 0.0f, 0.0f}, {0.0f, 0.0f, -3.0f}};

// A lamp of intensity I at height h above the plane: E = I cos³θ / h².
const Test point("analytic.illuminance.point_above_a_plane", [] {
    const scene::PointLight lamp{.name = "", .position = {0.27f, 2.8f, -0.17f}, .I = vec3(900.0f)};
    // The floor is below; a shelf above the lamp casts no shadow.
    scene::Scene room = lambert_plane(5.0f);
    add_quad(room, {0, 3.5f, 0}, {1, 0, 0}, {0, 0, 1}, lambert());
    const auto grid = measured(room, {lamp}, desk, 40, 30, 1);
    for (int row = 0; row < grid.rows; ++row)
        for (int column = 0; column < grid.columns; ++column) {
            const glm::dvec3 to_lamp = glm::dvec3(lamp.position) - grid.center(column, row);
            const double h = 2.0, cos = h / glm::length(to_lamp);
            EXPECT_NEAR(grid.at(column, row) / (900.0 * cos * cos * cos / (h * h)), 1.0, 2e-4)
                << column << "," << row;
        }
    const auto summary = output::summary_of(grid);
    EXPECT_EQ(summary.max_place.column, 22); // the cell below the lamp, whose centre is at x = 0.25
    EXPECT_EQ(summary.max_place.row, 13);    // z = -0.15
    EXPECT_EQ(summary.dark_cells, 0u);
});

// The plane lies in a floor of its own height, which must not be drawn in its place.
const Test floor("analytic.illuminance.a_plane_in_the_floor", [] {
    const scene::PointLight lamp{.name = "", .position = {0, 2.0f, 0}, .I = vec3(400.0f)};
    const scene::Receiver plane{{-1, 0, 1}, {2, 0, 0}, {0, 0, -2}};
    scene::Scene scene = lambert_plane(1.0f);
    for (vec3& n : scene.meshes[0].normals) n = vec3(0.8f, 0.6f, 0.0f); // what the floor would show
    const auto grid = measured(scene, {lamp}, plane, 21, 21, 1);
    EXPECT_NEAR(grid.at(10, 10), 100.0, 0.02);
});

// A luminous ceiling panel of 1.2 × 0.6 m: the contour of Lambert 1760, at the cells' centres.
const Test panel("analytic.illuminance.panel_above_a_plane", [] {
    const scene::RectangleLight light{"", {0.2f, 2.8f, 0.1f}, {0.6f, 0, 0}, {0, 0, 0.3f}, vec3(1000.0f)};
    const auto corners = corners_of(light);
    const auto grid = measured({}, {light}, desk, 16, 12, 256);
    double sum = 0.0, expected = 0.0;
    for (int row = 0; row < grid.rows; ++row)
        for (int column = 0; column < grid.columns; ++column) {
            const double E = 1000.0 * polygon_irradiance(corners, grid.center(column, row));
            // A cell is 25 cm wide: its mean differs from its middle by the curvature of E.
            EXPECT_NEAR(grid.at(column, row) / E, 1.0, 0.03) << column << "," << row;
            sum += grid.at(column, row);
            expected += E;
        }
    EXPECT_NEAR(sum / expected, 1.0, 2e-3);
});

// A half of the desk lies below a wide board 10 cm above it, whose lamp is straight above its edge.
const Test shadow("analytic.illuminance.a_board_casts_its_shadow", [] {
    const scene::DirectionalLight sun{.name = "", .direction = {0, -1, 0}, .E = vec3(500.0f)};
    scene::Scene scene;
    add_quad(scene, {1.0f, 0.9f, 0}, {1, 0, 0}, {0, 0, -3}, lambert());
    const auto grid = measured(scene, {sun}, desk, 40, 30, 16);
    const auto summary = output::summary_of(grid);
    EXPECT_NEAR(summary.max, 500.0, 0.01);
    EXPECT_EQ(summary.dark_cells, 600u);
    EXPECT_NEAR(summary.mean, 250.0, 0.01);
    EXPECT_EQ(summary.min_over_mean(), 0.0);
});

// The same plane seen from below receives nothing of what comes from above.
const Test side("analytic.illuminance.one_side_receives", [] {
    const scene::DirectionalLight sun{.name = "", .direction = {0, -1, 0}, .E = vec3(500.0f)};
    const scene::Receiver turned{{-2.0f, 0.8f, -1.5f}, {4.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 3.0f}};
    EXPECT_EQ(output::summary_of(measured({}, {sun}, turned, 8, 6, 1)).max, 0.0);
    EXPECT_NEAR(output::summary_of(measured({}, {sun}, desk, 8, 6, 1)).min, 500.0, 0.01);
});

// Isolines of the distance from a point are circles: closed, and everywhere at that distance.
const Test circles("analytic.illuminance.isolines_of_a_cone_are_circles", [] {
    const vec2 middle(20.3f, 14.8f);
    const auto distance = [&](int column, int row) {
        return static_cast<double>(glm::length(vec2(column, row) - middle));
    };
    const auto lines = output::isolines(41, 31, distance, 9.0);
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_EQ(lines[0].front(), lines[0].back());
    double length = 0.0;
    for (std::size_t i = 0; i < lines[0].size(); ++i) {
        EXPECT_NEAR(glm::length(lines[0][i] - middle), 9.0, 0.02);
        if (i > 0) length += glm::length(lines[0][i] - lines[0][i - 1]);
    }
    EXPECT_NEAR(length, 2.0 * std::numbers::pi * 9.0, 0.2);
    EXPECT_EQ(output::isolines(41, 31, distance, 17.0).size(), 2u); // cut by the upper and the lower border
    EXPECT_TRUE(output::isolines(41, 31, distance, 99.0).empty());
});

const Test levels("analytic.illuminance.levels_are_round", [] {
    EXPECT_EQ(output::round_levels(0.0, 10.0, 4), (std::vector<double>{2, 4, 6, 8}));
    EXPECT_EQ(output::round_levels(130.0, 480.0, 8),
              (std::vector<double>{150, 200, 250, 300, 350, 400, 450}));
    EXPECT_TRUE(output::round_levels(5.0, 5.0, 8).empty());
});

} // namespace
