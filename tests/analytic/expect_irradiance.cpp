#include "analytic/expect_irradiance.hpp"

#include "support/gl.hpp"
#include "support/scenes.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <numbers>
#include <vector>

namespace sr::testing {
namespace {

// Under radiance 1 a whole sky gives π; of less than this, 1e-4 is the rounding of unit vectors of floats.
constexpr double min_irradiance = 1e-3;

} // namespace

void expect_irradiance(const scene::Light& light, const Irradiance& E, double half_extent, double tolerance) {
    constexpr int size = 9;
    context();
    const auto extent = static_cast<float>(half_extent);
    const std::vector<scene::Light> lights{light};
    const scene::Scene plane = lambert_plane(2.0f * extent);
    const render::GpuScene scene(plane, lights);
    render::RenderOptions options;
    options.width = options.height = size;
    options.samples = 1;
    options.estimator = render::Estimator::analytic;
    scene::Camera camera = camera_from_above(extent);
    render::Renderer renderer(scene, camera, options);
    renderer.add_sample();
    const image::Image film = renderer.read_film();

    std::vector<double> expected;
    double greatest = 0.0;
    for (int row = 0; row < size; ++row)
        for (int column = 0; column < size; ++column) {
            const vec2 place = place_of(column, row, size, extent);
            expected.push_back(E({place.x, 0.0, place.y}));
            greatest = std::max(greatest, expected.back());
        }
    ASSERT_GT(greatest, 0.0);
    const double floor = std::max(1e-3 * greatest, min_irradiance);
    double worst = 0.0;
    int wrong = 0;
    std::string where;
    for (int i = 0; i < size * size; ++i) {
        const double got = std::numbers::pi * film.at(i % size, i / size)[0];
        const double difference = std::abs(got - expected[i]) / std::max(expected[i], floor);
        wrong += !(difference <= tolerance);
        if (difference <= worst) continue;
        worst = difference;
        where = fmt::format("pixel {},{}: E {} for {}", i % size, i / size, got, expected[i]);
    }
    EXPECT_EQ(wrong, 0) << "pixels; the worst errs by " << worst << ", " << where;
    ::testing::Test::RecordProperty("max_relative_difference", std::to_string(worst));
}

} // namespace sr::testing
