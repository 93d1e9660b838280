#include "random_emitter.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sr::ltc {
namespace {

using glm::dvec3;

/// Within the unit ball between heights `low` and 1.
dvec3 in_ball(Random& random, double low) {
    for (;;) {
        const dvec3 v(random() * 2.0 - 1.0, random() * 2.0 - 1.0, low + random() * (1.0 - low));
        const double l2 = glm::dot(v, v);
        if (l2 <= 1.0 && l2 > 0.01) return v;
    }
}

struct Plane {
    dvec3 center, n, u, v; // n towards the origin
};

Plane random_plane(Random& random) {
    Plane p{};
    p.center = glm::normalize(in_ball(random, -0.3)) * (0.5 + 3.0 * random());
    p.n = glm::normalize(in_ball(random, -1.0));
    if (glm::dot(p.n, p.center) > 0.0) p.n = -p.n;
    p.u = glm::normalize(glm::cross(p.n, std::abs(p.n.x) < 0.7 ? dvec3(1, 0, 0) : dvec3(0, 1, 0)));
    p.v = glm::cross(p.n, p.u);
    return p;
}

double random_radius(Random& random) { return 0.2 * std::pow(10.0, random()); }

/// Half of them rectangles, the others of three to seven corners on an ellipse.
RandomEmitter polygon(Random& random) {
    const Plane p = random_plane(random);
    const double a = random_radius(random), b = random_radius(random);
    std::vector<dvec3> corners;
    if (random() < 0.5) {
        corners = {p.center + a * p.u + b * p.v, p.center - a * p.u + b * p.v, p.center - a * p.u - b * p.v,
                   p.center + a * p.u - b * p.v};
    } else {
        const int count = 3 + static_cast<int>(random() * 5.0);
        for (int k = 0; k < count; ++k) {
            const double t = 2.0 * std::numbers::pi * (k + 0.8 * random()) / count;
            corners.push_back(p.center + a * std::cos(t) * p.u + b * std::sin(t) * p.v);
        }
    }
    scene::PolygonLight light;
    for (const dvec3 corner : corners) light.corners.emplace_back(corner);
    light.is_two_sided = true;
    const auto meets = [corners, n = p.n](dvec3 w) { // on one side of all edges, and not behind
        bool left = false, right = false;
        for (std::size_t k = 0; k < corners.size(); ++k)
            (glm::dot(glm::cross(corners[k], corners[(k + 1) % corners.size()]), w) > 0.0 ? left : right) =
                true;
        return left != right && glm::dot(n, w) < 0.0;
    };
    return {light, meets};
}

RandomEmitter disk(Random& random) {
    const Plane p = random_plane(random);
    const double a = random_radius(random), b = random_radius(random);
    scene::DiskLight light{"", vec3(p.center), vec3(a * p.u), vec3(b * p.v)};
    light.is_two_sided = true;
    return {light, [p, a, b](dvec3 w) {
                const double towards = glm::dot(p.n, w);
                const dvec3 q = glm::dot(p.n, p.center) / towards * w - p.center;
                const double s = glm::dot(q, p.u) / a, t = glm::dot(q, p.v) / b;
                return towards < 0.0 && s * s + t * t <= 1.0;
            }};
}

RandomEmitter sphere(Random& random) {
    const dvec3 center = glm::normalize(in_ball(random, -0.3)) * (0.5 + 3.0 * random());
    const double radius = std::min(random_radius(random), 0.95 * glm::length(center));
    const double sin2 = radius * radius / glm::dot(center, center);
    return {scene::SphereLight{"", vec3(center), static_cast<float>(radius)}, [center, sin2](dvec3 w) {
                const double cosine = glm::dot(w, glm::normalize(center));
                return cosine > 0.0 && 1.0 - cosine * cosine <= sin2;
            }};
}

RandomEmitter tube(Random& random) {
    const Plane p = random_plane(random);
    const dvec3 half = random_radius(random) * p.u;
    const dvec3 start = p.center - half;
    const dvec3 axis = 2.0 * half;
    const double nearest = glm::clamp(-glm::dot(start, axis) / glm::dot(axis, axis), 0.0, 1.0);
    const double radius = std::min(0.25 * random_radius(random), 0.9 * glm::length(start + nearest * axis));
    return {scene::TubeLight{"", vec3(p.center), vec3(half), static_cast<float>(radius)},
            [start, axis, radius](dvec3 w) {
                const dvec3 across = axis - glm::dot(axis, w) * w;
                const double t = glm::clamp(-glm::dot(start, across) / glm::dot(across, across), 0.0, 1.0);
                const dvec3 q = start + t * axis;
                return glm::length(q - std::max(0.0, glm::dot(q, w)) * w) <= radius;
            }};
}

} // namespace

RandomEmitter random_emitter(Shape shape, Random& random) {
    switch (shape) {
    case Shape::disk: return disk(random);
    case Shape::sphere: return sphere(random);
    case Shape::tube: return tube(random);
    case Shape::polygon: break;
    }
    return polygon(random);
}

} // namespace sr::ltc
