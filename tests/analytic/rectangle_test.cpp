#include "irradiance.hpp"
#include "support/address.hpp"
#include "support/scenes.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

using namespace sr;
using namespace sr::testing;

namespace {

void expect_polygon_formula(const scene::RectangleLight& light) {
    constexpr int size = 129, samples = 64;
    constexpr float extent = 1.5f;
    // A pixel is a mean over its area as well, whose own error is not tested here: pixels are kept
    // small against the distance to the light.
    const std::vector<scene::Light> lights{light};
    const auto image = picture(lambert_plane(4.0f), lights, camera_from_above(extent), size, samples);
    const std::vector<glm::dvec3> corners = corners_of(light);
    double worst = 0.0;
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            const vec2 p = place_of(x, y, size, extent);
            const double expected = light.L.x * polygon_irradiance(corners, {p.x, 0.0, p.y}) / pi;
            worst = std::max(worst, std::abs(image.at(x, y)[0] / expected - 1.0));
        }
    }
    EXPECT_LT(worst, 0.005) << "largest relative difference over the picture";
    ::testing::Test::RecordProperty("max_relative_difference", std::to_string(worst));
}

const Test above("analytic.rectangle.lambert_plane_below", [] {
    expect_polygon_formula({"", {0.0f, 1.5f, 0.0f}, {0.5f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.35f}, vec3(100.0f)});
});

const Test tilted("analytic.rectangle.tilted", [] {
    const vec3 u(0.6f, 0.0f, 0.0f), v(0.0f, 0.2f, 0.4f); // faces down and back
    expect_polygon_formula({"", {0.4f, 1.8f, -0.6f}, u, v, vec3(40.0f)});
});

} // namespace
