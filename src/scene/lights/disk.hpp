#pragma once
// A light that is a disk or an ellipse.
#include "scene/lights/emitter.hpp"

#include <array>

namespace sr::scene {

/// A disk or an ellipse: the points center + s*half_u + t*half_v for s² + t² <= 1. Front as a rectangle's.
struct DiskLight {
    static constexpr std::string_view kind = "disk";

    std::string name;
    vec3 center{0.0f};             // [m]
    vec3 half_u{1.0f, 0.0f, 0.0f}; // a semi-axis [m]
    vec3 half_v{0.0f, 1.0f, 0.0f}; // the other [m], perpendicular to half_u
    vec3 L{1.0f};                  // radiance [cd/m²]
    bool is_two_sided = false;
    bool is_visible = true;
    EmissionMap map{};

    static constexpr std::array<Dimension<DiskLight>, 1> of_circle{
        {{"radius", "m", 1.0f, nullptr, &DiskLight::half_u, &DiskLight::half_v}}};
    static constexpr std::array<Dimension<DiskLight>, 2> of_ellipse{
        {{"width", "m", 2.0f, nullptr, &DiskLight::half_u},
         {"height", "m", 2.0f, nullptr, &DiskLight::half_v}}};
    static constexpr std::array<NamedShape<DiskLight>, 2> shapes{
        {{"disk", of_circle}, {"ellipse", of_ellipse}}};

    /// A circle's, where the semi-axes have one length but for rounding; else an ellipse's.
    std::span<const Dimension<DiskLight>> sizes() const;
    float area() const { return pi * glm::length(glm::cross(half_u, half_v)); } // [m²]
    vec3 normal() const { return glm::normalize(glm::cross(half_u, half_v)); }
    Radiator radiator() const;
    Bounds bounds() const;
    void transform(const Motion& by);
    std::optional<LightSurface> surface() const;
    EmitterPoint sample_point(vec3 u) const;
    EmitterPoint middle() const { return sample_point(vec3(0.0f)); }
};

} // namespace sr::scene
