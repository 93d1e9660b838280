// Spheres, the sun and tubes in closed form, whole and partly below the receiver's horizon.
#include "analytic/expect_irradiance.hpp"
#include "analytic/silhouette.hpp"
#include "support/address.hpp"

#include <algorithm>

using namespace sr;
using namespace sr::testing;
using glm::dvec3;

namespace {

/// A cone of half-angle sigma around `axis`, by rays.
double cone_irradiance(dvec3 axis, double sigma) {
    const dvec3 c = glm::normalize(axis);
    // The angle from its sine as well, since the cosine says nothing of small ones.
    return irradiance_of_convex(
        [&](dvec3 w) { return std::atan2(glm::length(glm::cross(w, c)), glm::dot(w, c)) <= sigma; }, c, up);
}

double sphere_irradiance(const scene::SphereLight& light, dvec3 x) {
    const dvec3 c = dvec3(light.center) - x;
    return cone_irradiance(c, std::asin(light.radius / glm::length(c)));
}

const Test whole_sphere("analytic.outline.sphere.closed_form", [] {
    // Wholly above the horizon E / L = π (r / d)² cosθ.
    const scene::SphereLight light{"", {0.3f, 0.9f, -0.2f}, 0.6f};
    expect_irradiance(
        light,
        [&](dvec3 x) {
            const dvec3 c = dvec3(light.center) - x;
            const double d2 = glm::dot(c, c);
            return std::numbers::pi * 0.36 * c.y / std::sqrt(d2) / d2;
        },
        2.0);
});

const Test half_sunk("analytic.outline.sphere.half_below_the_horizon", [] {
    // Its centre on the horizon: half the cone's disk, E / L = σ - sinσ cosσ with sinσ = r / d.
    const scene::SphereLight light{"", {0.0f, 0.0f, -3.0f}, 0.7f};
    expect_irradiance(
        light,
        [&](dvec3 x) {
            const double sigma = std::asin(0.7f / glm::length(dvec3(light.center) - x));
            return sigma - std::sin(sigma) * std::cos(sigma);
        },
        2.0);
});

const Test cut("analytic.outline.sphere.through_the_horizon", [] {
    for (const float height : {0.35f, -0.25f}) {
        const scene::SphereLight light{"", {0.2f, height, -2.8f}, 0.7f};
        expect_irradiance(
            light, [&](dvec3 x) { return sphere_irradiance(light, x); }, 2.0);
    }
});

const Test sun("analytic.outline.sun", [] {
    scene::DirectionalLight light;
    light.direction = glm::normalize(vec3(0.3f, -0.8f, 0.5f));
    for (const float sigma : {0.00465f, 0.4f}) {
        light.angular_radius = sigma;
        const double cos_i = -light.direction.y;
        expect_irradiance(
            light, [&](dvec3) { return cos_i; }, 2.0);
    }
    light.direction = glm::normalize(vec3(0.3f, -0.1f, 0.5f)); // 10° above the horizon, 23° wide: partly set
    const double L = 1.0 / (std::numbers::pi * std::pow(std::sin(double(light.angular_radius)), 2.0));
    const double E = L * cone_irradiance(-dvec3(light.direction), light.angular_radius);
    expect_irradiance(
        light, [&](dvec3) { return E; }, 2.0);
});

/// A capsule by rays: the least distance between the ray and the axis.
double tube_irradiance(const scene::TubeLight& light, dvec3 x) {
    const dvec3 p = dvec3(light.center) - dvec3(light.half_axis) - x;
    const dvec3 d = 2.0 * dvec3(light.half_axis);
    const double r = light.radius;
    const auto meets = [&](dvec3 w) {
        // The point p + t d nearest to the line of w, then, with t in [0, 1], its distance to the ray.
        const dvec3 across = d - glm::dot(d, w) * w;
        const dvec3 start = p - glm::dot(p, w) * w;
        const double length2 = glm::dot(across, across);
        const double t = length2 > 0.0 ? glm::clamp(-glm::dot(start, across) / length2, 0.0, 1.0) : 0.0;
        const dvec3 q = p + t * d;
        const double along = std::max(0.0, glm::dot(q, w));
        return glm::length(q - along * w) <= r;
    };
    return irradiance_of_convex(meets, dvec3(light.center) - x, up);
}

void expect_tube(vec3 center, vec3 half_axis, float radius) {
    const scene::TubeLight light{"", center, half_axis, radius};
    expect_irradiance(
        light, [&](dvec3 x) { return tube_irradiance(light, x); }, 2.0);
}

const Test tube("analytic.outline.tube", [] { expect_tube({0.3f, 0.8f, -0.2f}, {0.5f, 0.2f, 0.3f}, 0.15f); });

const Test standing("analytic.outline.tube.seen_along_its_axis", [] {
    expect_tube({0.0f, 1.0f, 0.0f}, {0.0f, 0.4f, 0.0f}, 0.3f);
});

const Test cut_tube("analytic.outline.tube.through_the_horizon", [] {
    expect_tube({0.1f, 0.1f, -2.6f}, {1.0f, 0.3f, 0.1f}, 0.3f);
    expect_tube({0.1f, 0.0f, -2.6f}, {0.9f, 0.0f, 0.0f}, 0.3f);
    expect_tube({0.0f, 0.4f, -3.0f}, {0.0f, 0.6f, 0.2f}, 0.25f);
    expect_tube({0.1f, -0.22f, -2.6f}, {0.4f, 0.0f, 0.0f}, 0.3f); // only the crest looks over it
});

} // namespace
