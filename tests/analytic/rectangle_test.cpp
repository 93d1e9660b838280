#include "support/address.hpp"
#include "support/scenes.hpp"

#include <cmath>
#include <vector>

using namespace sr;
using namespace sr::testing;

namespace {

// Irradiance of a polygon of radiance 1 on a plane through `x` with normal +Y, which the polygon is wholly
// above: E = 1/2 Σ θ_k (Γ_k · n), with θ_k the angle that edge k subtends and Γ_k the unit normal of its
// plane through x (Lambert 1760; in this form Baum et al. 1989, Eq. 5). In doubles.
double polygon_irradiance(const std::vector<glm::dvec3>& corners, glm::dvec3 x) {
    double E = 0.0;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const glm::dvec3 a = glm::normalize(corners[k] - x);
        const glm::dvec3 b = glm::normalize(corners[(k + 1) % corners.size()] - x);
        const glm::dvec3 gamma = glm::cross(a, b);
        const double s = glm::length(gamma);
        if (s > 0.0) E += std::atan2(s, glm::dot(a, b)) * gamma.y / s;
    }
    return 0.5 * std::abs(E);
}

void expect_polygon_formula(const scene::RectangleLight& light) {
    constexpr int size = 129, samples = 64;
    constexpr float extent = 1.5f;
    // A pixel is a mean over its area as well, whose own error is not what is asked for here: pixels are kept
    // small against the distance to the light.
    const std::vector<scene::Light> lights{light};
    const auto image = picture(lambert_plane(4.0f), lights, camera_from_above(extent), size, samples);
    const vec3 c = light.center, u = light.half_u, v = light.half_v;
    const std::vector<glm::dvec3> corners{c - u - v, c + u - v, c + u + v, c - u + v};
    double worst = 0.0;
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            const vec2 p = place_of(x, y, size, extent);
            const double expected = light.L.x * polygon_irradiance(corners, {p.x, 0.0, p.y}) / pi;
            worst = std::max(worst, std::abs(image.at(x, y)[0] / expected - 1.0));
        }
    }
    EXPECT_LT(worst, 0.005) << "largest relative difference over the picture";
    ::testing::Test::RecordProperty("largest_relative_difference", std::to_string(worst));
}

const Test above("analytic.rectangle.lambert_plane_below", [] {
    expect_polygon_formula({"", {0.0f, 1.5f, 0.0f}, {0.5f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.35f}, vec3(100.0f)});
});

const Test tilted("analytic.rectangle.tilted", [] {
    const vec3 u(0.6f, 0.0f, 0.0f), v(0.0f, 0.2f, 0.4f); // faces down and back
    expect_polygon_formula({"", {0.4f, 1.8f, -0.6f}, u, v, vec3(40.0f)});
});

} // namespace
