// Illuminance on a measuring plane against closed forms.
#include "core/math.hpp"
#include "output/illuminance.hpp"
#include "support/address.hpp"
#include "support/gl.hpp"
#include "support/scenes.hpp"

#include <cmath>

using namespace sr;
using sr::output::IlluminanceTable, sr::output::MeasuringPlane;
using sr::testing::Test;

namespace {

constexpr float I = 500.0f; // intensity [cd]
constexpr float h = 2.2f;   // height of the light above the plane [m]

scene::RenderScene lit_by(const scene::Light& light) {
    scene::RenderScene stage;
    stage.lights = {light};
    stage.scene.lights = stage.lights;
    return stage;
}

IlluminanceTable measured(const MeasuringPlane& plane, const scene::RenderScene& stage, int samples = 1) {
    sr::testing::context();
    render::RenderOptions options;
    options.samples = samples;
    return output::illuminance_on(plane, stage, render::Visibility::ray, options);
}

/// E = I cos³θ / h², with θ from the nadir.
double point_law(glm::dvec2 at) {
    const double cosine = h / std::sqrt(glm::dot(at, at) + h * h);
    return I * cosine * cosine * cosine / (h * h);
}

const Test point("law.photometry.illuminance.of_a_point_light_is_I_cos3_over_h2", [] {
    const MeasuringPlane plane{0.8, {-2.0, -1.5}, {3.0, 1.5}, 50, 30};
    const IlluminanceTable table =
        measured(plane, lit_by(scene::PointLight{"", {0.0f, 3.0f, 0.0f}, vec3(I)}));
    for (int row = 0; row < plane.rows; ++row)
        for (int column = 0; column < plane.columns; ++column) {
            const double expected = point_law(plane.center_of(column, row));
            ASSERT_NEAR(table.at(column, row), expected, 2e-5 * expected) << column << ", " << row;
        }
    EXPECT_NEAR(table.max(), I / (h * h), 1e-2 * I / (h * h));
    EXPECT_NEAR(table.uniformity(), table.min() / table.mean(), 1e-12);
    EXPECT_LT(table.min(), table.mean());
});

const Test far("law.photometry.illuminance.does_not_depend_on_the_origin", [] {
    const MeasuringPlane near{0.8, {-1.0, -1.0}, {1.0, 1.0}, 8, 8};
    MeasuringPlane away = near;
    const glm::dvec3 origin(4e6, 100.0, -5e6);
    away.height += origin.y;
    away.from += glm::dvec2(origin.x, origin.z);
    away.to += glm::dvec2(origin.x, origin.z);
    scene::RenderScene stage = lit_by(scene::PointLight{"", {0.2f, 3.0f, 0.1f}, vec3(I)});
    const IlluminanceTable expected = measured(near, stage);
    stage.scene.origin = origin;
    const IlluminanceTable table = measured(away, stage);
    for (std::size_t i = 0; i < table.values.size(); ++i)
        EXPECT_NEAR(table.values[i], expected.values[i], 1e-4f * expected.values[i]) << i;
});

const Test shadow("law.photometry.illuminance.has_the_shadows_of_what_is_above_and_casts_none", [] {
    scene::RenderScene stage = lit_by(scene::PointLight{"", {0.0f, 3.0f, 0.0f}, vec3(I)});
    sr::testing::add_quad(stage.scene, {1.0f, 1.9f, 0.0f}, {0.0f, 0.0f, 0.5f}, {0.5f, 0.0f, 0.0f},
                          scene::Material());
    // The quad from x = 0.5 to 1.5 at half the height shades 1 to 3 on the plane, and what is below it
    // nothing.
    sr::testing::add_quad(stage.scene, {-1.0f, 0.4f, 0.0f}, {0.0f, 0.0f, 0.5f}, {0.5f, 0.0f, 0.0f},
                          scene::Material());
    const MeasuringPlane plane{0.8, {-3.0, -0.25}, {3.0, 0.25}, 60, 5};
    const IlluminanceTable table = measured(plane, stage);
    for (int column = 0; column < plane.columns; ++column) {
        const glm::dvec2 at = plane.center_of(column, 2);
        const double expected = at.x > 1.0 && at.x < 3.0 ? 0.0 : point_law(at);
        EXPECT_NEAR(table.at(column, 2), expected, 2e-5 * point_law(at)) << at.x;
    }
});

const Test levels("law.photometry.illuminance.isolines_are_at_round_values_between_the_extremes", [] {
    for (const double scale : {0.003, 1.0, 740.0}) {
        IlluminanceTable table{{0.0, {0, 0}, {1, 1}, 3, 1}, {}};
        for (const double value : {1.3, 4.0, 9.7}) table.values.push_back(static_cast<float>(scale * value));
        const std::vector<double> levels = output::isoline_levels(table);
        ASSERT_TRUE(levels.size() >= 4 && levels.size() <= 10) << scale;
        EXPECT_GT(levels.front(), table.min());
        EXPECT_LT(levels.back(), table.max());
        for (std::size_t i = 1; i < levels.size(); ++i)
            EXPECT_NEAR(levels[i] - levels[i - 1], levels[1] - levels[0], 1e-9 * scale);
    }
    IlluminanceTable even{{0.0, {0, 0}, {1, 1}, 2, 1}, {5.0f, 5.0f}};
    EXPECT_TRUE(output::isoline_levels(even).empty());
});

} // namespace
