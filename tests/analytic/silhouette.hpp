#pragma once
// Irradiance of anything convex in doubles, by finding its outline with rays: no formula of an outline is
// used.
#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/glm.hpp>
#include <numbers>

namespace sr::testing {

inline const glm::dvec3 up(0.0, 1.0, 0.0);

/// Returns whether a ray from x in direction w meets the emitter.
using Meets = std::function<bool(glm::dvec3 w)>;

/// ∫ max(n·w, 0) dω over the directions that meet a convex emitter [sr], for one direction `inside` of them.
/// Around it, in equal steps of azimuth, the angle ψ to the outline by bisection; over ψ the integral is
/// elementary.
inline double irradiance_of_convex(const Meets& meets, glm::dvec3 inside, glm::dvec3 n, int azimuths = 4000) {
    constexpr double pi = std::numbers::pi;
    const glm::dvec3 c = glm::normalize(inside);
    const glm::dvec3 u =
        glm::normalize(glm::cross(c, std::abs(c.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
    const glm::dvec3 v = glm::cross(c, u);
    double E = 0.0;
    for (int i = 0; i < azimuths; ++i) {
        const double phi = 2.0 * pi * (i + 0.5) / azimuths;
        const glm::dvec3 e = std::cos(phi) * u + std::sin(phi) * v;
        double within = 0.0;
        double beyond = pi;
        for (int step = 0; step < 46; ++step) {
            const double middle = 0.5 * (within + beyond);
            (meets(std::cos(middle) * c + std::sin(middle) * e) ? within : beyond) = middle;
        }
        // n·w = A cosψ + B sinψ, positive from `rise` to `set`.
        const double A = glm::dot(n, c);
        const double B = glm::dot(n, e);
        const double middle = std::atan2(B, A); // where n·w is greatest
        const double rise = std::max(0.0, middle - 0.5 * pi);
        const double set = std::min(within, middle + 0.5 * pi);
        const auto primitive = [&](double psi) {
            const double s = std::sin(psi);
            return 0.5 * A * s * s + 0.5 * B * (psi - s * std::cos(psi));
        };
        if (set > rise) E += primitive(set) - primitive(rise);
    }
    return E * 2.0 * pi / azimuths;
}

} // namespace sr::testing
