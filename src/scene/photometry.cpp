#include "scene/photometry.hpp"

#include <algorithm>
#include <cmath>

namespace sr::scene {
namespace {

constexpr double pi64 = 3.14159265358979323846;

double length64(vec3 v) { return glm::length(glm::dvec3(v)); }

double parallelogram(vec3 u, vec3 v) { return glm::length(glm::cross(glm::dvec3(u), glm::dvec3(v))); }

template<class Flat>
Radiator flat(const Flat& light, double area) {
    return {light.is_two_sided ? 2.0 * area : area, area};
}

/// ∫ (a + b γ) sinγ dγ from g0 to g1 for the line through (g0, I0) and (g1, I1).
double over_gamma(double g0, double I0, double g1, double I1) {
    const double b = g1 > g0 ? (I1 - I0) / (g1 - g0) : 0.0;
    const auto antiderivative = [&](double g) { // of (I0 + b (γ - g0)) sinγ
        return -(I0 + b * (g - g0)) * std::cos(g) + b * std::sin(g);
    };
    return antiderivative(g1) - antiderivative(g0);
}

struct FluxOf {
    const std::vector<LightProfile>& profiles;

    std::optional<vec3> operator()(const PointLight& light) const {
        const double times =
            light.profile < 0 ? 4.0 * pi64 : flux_of(profiles[static_cast<std::size_t>(light.profile)]);
        return vec3(times * glm::dvec3(light.I));
    }
    std::optional<vec3> operator()(const SpotLight& light) const {
        return vec3(spot_solid_angle(light.inner_angle, light.outer_angle) * glm::dvec3(light.I));
    }
    std::optional<vec3> operator()(const DirectionalLight&) const { return std::nullopt; }
    std::optional<vec3> operator()(const EnvironmentLight&) const { return std::nullopt; }

    template<class Area>
    std::optional<vec3> operator()(const Area& light) const {
        return vec3(pi64 * radiator_of(light).flux_area * glm::dvec3(light.L));
    }
};

} // namespace

double converted(double value, UnitSystem from, UnitSystem to, double efficacy) {
    if (from == to) return value;
    return to == UnitSystem::photometric ? value * efficacy : value / efficacy;
}

Radiator radiator_of(const RectangleLight& light) {
    return flat(light, 4.0 * parallelogram(light.half_u, light.half_v));
}

Radiator radiator_of(const DiskLight& light) {
    return flat(light, pi64 * parallelogram(light.half_u, light.half_v));
}

Radiator radiator_of(const PolygonLight& light) { return flat(light, light.area()); }

Radiator radiator_of(const SphereLight& light) {
    const double disk = pi64 * light.radius * light.radius;
    return {4.0 * disk, disk};
}

Radiator radiator_of(const TubeLight& light) {
    const double r = light.radius, h = length64(light.half_axis);
    return {4.0 * pi64 * r * (r + h), 4.0 * r * h + pi64 * r * r};
}

Radiator radiator_of(const MeshLight& light) {
    double area = 0.0;
    for (const auto& [corners, uv] : light.triangles)
        area += 0.5 * parallelogram(corners[1] - corners[0], corners[2] - corners[0]);
    return {light.is_two_sided ? 2.0 * area : area, std::nullopt};
}

std::optional<double> radiance_from(Quantity quantity, double value, const Radiator& radiator) {
    if (quantity == Quantity::flux) return value / (pi64 * radiator.flux_area);
    if (quantity == Quantity::intensity && radiator.axis_area) return value / *radiator.axis_area;
    if (quantity == Quantity::radiance) return value;
    return std::nullopt;
}

std::optional<double> point_intensity_from(Quantity quantity, double value, double radius) {
    if (quantity == Quantity::flux) return value / (4.0 * pi64);
    if (quantity == Quantity::intensity) return value;
    if (quantity == Quantity::radiance && radius > 0.0) return value * pi64 * radius * radius;
    return std::nullopt;
}

double spot_solid_angle(double inner_angle, double outer_angle) {
    const double cos_outer = std::cos(outer_angle);
    const double w = std::max(0.001, std::cos(inner_angle) - cos_outer);
    const double rise =
        std::min(w, 1.0 - cos_outer); // a cone narrower than the guard ends before the plateau
    return 2.0 * pi64 * ((1.0 - cos_outer - rise) + rise * rise * rise / (3.0 * w * w));
}

std::optional<double> spot_intensity_from(Quantity quantity, double value, const SpotLight& spot) {
    if (quantity == Quantity::flux) return value / spot_solid_angle(spot.inner_angle, spot.outer_angle);
    return point_intensity_from(quantity, value, spot.radius);
}

std::optional<double> sun_irradiance_from(Quantity quantity, double value, double angular_radius) {
    if (quantity == Quantity::irradiance) return value;
    const double sine = std::sin(angular_radius);
    if (quantity == Quantity::radiance && angular_radius > 0.0) return pi64 * value * sine * sine;
    return std::nullopt;
}

double flux_of(const LightProfile& profile) {
    const std::size_t rows = profile.gamma.size();
    std::vector<double> columns; // ∫ I sinγ dγ at each φ
    for (std::size_t c = 0; c < profile.phi.size(); ++c) {
        double sum = 0.0;
        for (std::size_t r = 1; r < rows; ++r)
            sum += over_gamma(profile.gamma[r - 1], profile.I[c * rows + r - 1], profile.gamma[r],
                              profile.I[c * rows + r]);
        columns.push_back(sum);
    }
    double flux = 0.0;
    for (std::size_t c = 1; c < columns.size(); ++c)
        flux += 0.5 * (columns[c] + columns[c - 1])
                * (static_cast<double>(profile.phi[c]) - static_cast<double>(profile.phi[c - 1]));
    return flux;
}

std::optional<vec3> flux_of(const Light& light, const std::vector<LightProfile>& profiles) {
    return std::visit(FluxOf{profiles}, light);
}

} // namespace sr::scene
