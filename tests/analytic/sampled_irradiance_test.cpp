#include "irradiance.hpp"
#include "scene/prepare.hpp"
#include "support/address.hpp"
#include "support/scenes.hpp"

#include <cmath>
#include <fmt/format.h>

using namespace sr;
using namespace sr::testing;

namespace {

/// The root mean square of the relative errors of 24×24 pixels that all look at the origin, N samples each:
/// what an estimator misses E by. (The picture covers 2 µm; sub-pixel offsets change nothing.)
double error_of(const scene::Scene& plane, const scene::Light& light, double E, int samples) {
    constexpr int size = 24;
    const std::vector<scene::Light> lights{light};
    const auto image = picture(plane, lights, camera_from_above(1e-6f), size, samples);
    double sum = 0.0, mean = 0.0;
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            const double relative = image.at(x, y)[0] * glm::pi<double>() / E - 1.0;
            sum += relative * relative;
            mean += relative;
        }
    }
    // A systematic error shows in the mean of all pixels long before it shows in one.
    const double error = std::sqrt(sum / (size * size));
    EXPECT_LT(std::abs(mean) / (size * size), 4.0 * error / size + 5e-5) << samples << " samples";
    return error;
}

void expect_convergence(const scene::Light& light, double E) {
    const scene::Scene plane = lambert_plane(1.0f);
    double previous = error_of(plane, light, E, 16);
    std::string curve = fmt::format("16: {:.2e}", previous);
    const double first = previous;
    for (const int samples : {256, 4096}) {
        const double error = error_of(plane, light, E, samples);
        curve += fmt::format(", {}: {:.2e}", samples, error);
        if (samples == 256) {
            EXPECT_LT(error, 0.005) << curve;
        }
        previous = error;
    }
    // Below 1e-5 what is left is 32-bit rounding of the pixel.
    if (previous > 1e-5) {
        EXPECT_GE(std::log(first / previous) / std::log(256.0), 0.7) << curve;
    }
    ::testing::Test::RecordProperty("error", curve);
}

const Test rectangle("analytic.sampled.rectangle", [] {
    const scene::RectangleLight light{"", {0.2f, 1, 0.1f}, {0.5f, 0, 0}, {0, 0, 0.35f}, vec3(1.0f)};
    expect_convergence(light, polygon_irradiance(corners_of(light), {0, 0, 0}));
});

const Test rising("analytic.sampled.rectangle_through_the_horizon", [] {
    const scene::RectangleLight light{"", {1.0f, 0.1f, 0}, {0, 0, 0.5f}, {0, 0.4f, 0}, vec3(1.0f)};
    expect_convergence(light, polygon_irradiance(corners_of(light), {0, 0, 0}));
});

const Test disk("analytic.sampled.disk", [] {
    const scene::DiskLight light{"", {0.2f, 1, 0.1f}, {0.5f, 0, 0}, {0, 0, 0.35f}, vec3(1.0f)};
    expect_convergence(light, disk_irradiance(light, {0, 0, 0}));
});

// A disk that a plane faces squarely: E = π L sin²σ (a Lambert disk of half angle σ).
const Test coaxial("analytic.sampled.coaxial_disk", [] {
    const scene::DiskLight light{"", {0, 1, 0}, {0.75f, 0, 0}, {0, 0, 0.75f}, vec3(1.0f)};
    const double expected = glm::pi<double>() * 0.75 * 0.75 / (1.0 + 0.75 * 0.75);
    EXPECT_NEAR(disk_irradiance(light, {0, 0, 0}) / expected, 1.0, 1e-6);
    expect_convergence(light, expected);
});

// (Off the plane z = 0: there the frame around the axis turns over, and half of a pixel's samples with it.)
const Test sphere("analytic.sampled.sphere", [] {
    const scene::SphereLight light{"", {0.6f, 0.8f, 0.1f}, 0.4f, vec3(1.0f)};
    expect_convergence(light, sphere_irradiance(light, {0, 0, 0}));
});

const Test setting_sphere("analytic.sampled.sphere_through_the_horizon", [] {
    const scene::SphereLight light{"", {1.0f, 0.1f, 0.1f}, 0.4f, vec3(1.0f)};
    expect_convergence(light, sphere_irradiance(light, {0, 0, 0}));
});

const Test polygon("analytic.sampled.polygon", [] {
    const scene::PolygonLight light{
        "",
        {{0.5f, 1, 0}, {0.2f, 1, 0.5f}, {-0.4f, 1, 0.3f}, {-0.4f, 1, -0.3f}, {0.2f, 1, -0.5f}},
        vec3(1.0f)};
    expect_convergence(light, polygon_irradiance(corners_of(light), {0, 0, 0}));
});

// The sun's disk of angular radius σ at the zenith angle θ: E cosθ, whatever σ is, while it is up.
const Test sun("analytic.sampled.sun", [] {
    const scene::DirectionalLight light{"", {-0.6f, -0.8f, 0}, vec3(1.0f), 0.3f};
    expect_convergence(light, 0.8);
});

// A tube is a cylinder and two halves of a ball; seen squarely from the side and thin, its irradiance is that
// of a linear source (Siegel & Howell): E = L 2r/h · (sin χ cos χ + χ), χ = atan(l/h), plus what the ends
// add.
const Test tube("analytic.sampled.thin_tube", [] {
    const scene::TubeLight light{"", {0, 1, 0}, {0.75f, 0, 0}, 1e-3f, vec3(1.0f)};
    const double chi = std::atan(0.75), cosine = std::cos(chi);
    // Either end is half a disk of radius r at the distance 1/cosχ, seen under half its outline more than the
    // cut that the linear source ends with: below r/l of it all.
    const double linear = 2e-3 * (std::sin(chi) * std::cos(chi) + chi) * 0.5 * 2.0;
    const double ends = glm::pi<double>() * 1e-6 * cosine * cosine * cosine;
    expect_convergence(light, linear + ends);
});

// An emissive mesh gives what the polygons that it is made of give: a cube's top and front are seen, with
// their triangles split unevenly.
const Test mesh("analytic.sampled.mesh", [] {
    scene::MeshLight light{"", {}, vec3(1.0f)};
    const vec3 a(-0.4f, 1, -0.4f), b(0.6f, 1, -0.4f), c(0.6f, 1, 0.5f), d(-0.4f, 1, 0.5f), m(0.4f, 1, 0.2f);
    for (const auto& [p, q] : {std::pair{a, b}, {b, c}, {c, d}, {d, a}})
        light.triangles.push_back({{p, q, m}, {}});
    const std::vector<glm::dvec3> corners{a, b, c, d};
    expect_convergence(light, polygon_irradiance(corners, {0, 0, 0}));
});

} // namespace
