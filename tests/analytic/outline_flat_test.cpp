// Flat emitters in closed form, whole and partly below the receiver's horizon.
#include "analytic/expect_irradiance.hpp"
#include "analytic/silhouette.hpp"
#include "support/address.hpp"

#include <algorithm>
#include <vector>

using namespace sr;
using namespace sr::testing;
using glm::dvec3;

namespace {

/// E of a polygon of radiance 1 above x, cut at the plane y = x.y (Sutherland & Hodgman 1974), by Lambert's
/// formula (Baum et al. 1989, Eq. 5).
double polygon_irradiance(const std::vector<dvec3>& corners, dvec3 x) {
    std::vector<dvec3> above;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const dvec3 a = corners[k] - x;
        const dvec3 b = corners[(k + 1) % corners.size()] - x;
        if (a.y >= 0.0) above.push_back(a);
        if ((a.y >= 0.0) != (b.y >= 0.0)) above.push_back(a + a.y / (a.y - b.y) * (b - a));
    }
    double E = 0.0;
    for (std::size_t k = 0; k < above.size(); ++k) {
        const dvec3 a = glm::normalize(above[k]);
        const dvec3 b = glm::normalize(above[(k + 1) % above.size()]);
        const dvec3 gamma = glm::cross(a, b);
        const double s = glm::length(gamma);
        if (s > 0.0) E += std::atan2(s, glm::dot(a, b)) * gamma.y / s;
    }
    return 0.5 * std::abs(E);
}

/// Of one that emits on its front only.
double one_sided(const std::vector<dvec3>& corners, dvec3 x) {
    const dvec3 front = glm::cross(corners[1] - corners[0], corners[2] - corners[1]);
    return glm::dot(front, corners[0] - x) < 0.0 ? polygon_irradiance(corners, x) : 0.0;
}

std::vector<dvec3> corners_of(const scene::RectangleLight& r) {
    const dvec3 c(r.center), u(r.half_u), v(r.half_v);
    return {c - u - v, c + u - v, c + u + v, c - u + v};
}

scene::RectangleLight rectangle(vec3 center, vec3 half_u, vec3 half_v, bool is_two_sided = false) {
    scene::RectangleLight light{"", center, half_u, half_v};
    light.is_two_sided = is_two_sided;
    return light;
}

const Test whole("analytic.outline.rectangle", [] {
    const auto light = rectangle({0.4f, 1.5f, -0.6f}, {0.6f, 0, 0}, {0, 0.2f, 0.4f});
    expect_irradiance(
        light, [&](dvec3 x) { return one_sided(corners_of(light), x); }, 2.0);
});

const Test far_away("analytic.outline.rectangle.of_a_degree", [] {
    const auto light = rectangle({1.0f, 9.0f, -0.6f}, {0.08f, 0, 0}, {0, 0.02f, 0.08f});
    expect_irradiance(
        light, [&](dvec3 x) { return one_sided(corners_of(light), x); }, 2.0);
});

const Test through("analytic.outline.rectangle.through_the_horizon", [] {
    const auto light =
        rectangle({0.1f, 0.2f, -1.0f}, {1.1f, 0.3f, 0}, glm::normalize(vec3(-0.3f, 1.1f, 0.4f)));
    expect_irradiance(
        light, [&](dvec3 x) { return one_sided(corners_of(light), x); }, 2.0);
});

const Test two_sided("analytic.outline.rectangle.two_sided", [] {
    const auto light = rectangle({0.1f, 0.3f, 0.01f}, {0.7f, 0.3f, 0}, {-0.15f, 0.35f, 0}, true);
    const auto wall = rectangle({0.1f, 0.3f, 0.0f}, {0.7f, 0.1f, 0}, {0, 0.5f, 0.1f}, true);
    expect_irradiance(
        wall, [&](dvec3 x) { return polygon_irradiance(corners_of(wall), x); }, 2.0);
    expect_irradiance(
        light, [&](dvec3 x) { return polygon_irradiance(corners_of(light), x); }, 2.0);
});

const Test polygon("analytic.outline.polygon", [] {
    scene::PolygonLight light;
    for (int k = 0; k < 7; ++k) { // irregular, convex, faces down and to the side
        const double t = 2.0 * std::numbers::pi * (k + 0.3 * std::sin(3.0 * k)) / 7.0;
        light.corners.emplace_back(0.5 + 0.9 * std::cos(t), 0.8 + 0.45 * std::cos(t), 0.6 * std::sin(t));
    }
    const auto expect = [&] {
        std::vector<dvec3> corners(light.corners.begin(), light.corners.end());
        expect_irradiance(
            light, [&](dvec3 x) { return one_sided(corners, x); }, 2.0);
    };
    expect();
    std::reverse(light.corners.begin(), light.corners.end());
    expect();
    for (vec3& corner : light.corners) corner.y -= 0.75f; // through the floor
    expect();
});

const Test mesh("analytic.outline.mesh", [] {
    scene::MeshLight light; // an octahedron, of which every receiver sees some triangles
    const vec3 center(0.3f, 0.4f, 0.2f);
    const vec3 tips[6] = {{0.6f, 0, 0},  {-0.6f, 0, 0}, {0, 0.6f, 0},
                          {0, -0.6f, 0}, {0, 0, 0.6f},  {0, 0, -0.6f}};
    for (int i = 0; i < 8; ++i) {
        vec3 a = tips[i & 1], b = tips[2 + (i >> 1 & 1)], c = tips[4 + (i >> 2)];
        if (glm::dot(glm::cross(b - a, c - a), a + b + c) < 0.0f) std::swap(b, c);
        light.triangles.push_back({{center + a, center + b, center + c}, {}});
    }
    expect_irradiance(
        light,
        [&](dvec3 x) {
            double E = 0.0;
            for (const auto& t : light.triangles) E += one_sided({t.corners.begin(), t.corners.end()}, x);
            return E;
        },
        2.0);
});

/// A disk or ellipse by rays; it emits on its front.
double ellipse_irradiance(const scene::DiskLight& light, dvec3 x) {
    const dvec3 c = dvec3(light.center) - x, u(light.half_u), v(light.half_v);
    const dvec3 n = glm::normalize(glm::cross(u, v));
    if (glm::dot(n, c) >= 0.0) return 0.0;
    const auto meets = [&](dvec3 w) {
        const double d = glm::dot(n, c) / glm::dot(n, w);
        const dvec3 q = d * w - c;
        const double s = glm::dot(q, u) / glm::dot(u, u), t = glm::dot(q, v) / glm::dot(v, v);
        return d > 0.0 && s * s + t * t <= 1.0;
    };
    return irradiance_of_convex(meets, c, up);
}

const Test disk_closed("analytic.outline.disk.closed_form", [] {
    // A receiver parallel to the disk, h below it and a off its axis (Foote 1915; with a = 0, π sin² of the
    // half angle):
    //   E / L = π/2 (1 - (h² + a² - r²) / √((h² + a² + r²)² - 4 r² a²))
    const double r = 0.8, h = 0.6;
    const scene::DiskLight light{"", {0.0f, 0.6f, 0.0f}, {0.8f, 0, 0}, {0, 0, 0.8f}};
    expect_irradiance(
        light,
        [&](dvec3 x) {
            const double a2 = x.x * x.x + x.z * x.z, sum = h * h + a2 + r * r;
            return 0.5 * std::numbers::pi
                   * (1.0 - (sum - 2.0 * r * r) / std::sqrt(sum * sum - 4.0 * r * r * a2));
        },
        2.0);
});

const Test ellipse("analytic.outline.disk.slanted_ellipse", [] {
    const scene::DiskLight light{"", {0.4f, 1.0f, -0.3f}, {0.9f, 0.2f, 0}, {-0.05f, 0.225f, 0.3f}};
    expect_irradiance(
        light, [&](dvec3 x) { return ellipse_irradiance(light, x); }, 2.0);
});

const Test cut_disk("analytic.outline.disk.through_the_horizon", [] {
    const scene::DiskLight light{"", {0.1f, 0.15f, -0.8f}, {0.9f, 0.2f, 0}, {-0.1f, 0.45f, 0.2f}};
    expect_irradiance(
        light, [&](dvec3 x) { return ellipse_irradiance(light, x); }, 2.0);
});

} // namespace
