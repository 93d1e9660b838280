#pragma once
// A light that is a tube with round ends.
#include "scene/lights/emitter.hpp"

#include <array>

namespace sr::scene {

/// A capsule, all points within `radius` of the axis from center - half_axis to center + half_axis. Emits the
/// radiance L outwards.
struct TubeLight {
    static constexpr std::string_view kind = "tube";

    std::string name;
    vec3 center{0.0f};                // [m]
    vec3 half_axis{0.5f, 0.0f, 0.0f}; // [m]
    float radius = 0.02f;             // [m]
    vec3 L{1.0f};                     // radiance [cd/m²]
    bool is_visible = true;

    static constexpr std::array<Dimension<TubeLight>, 2> dimensions{
        {{"length", "m", 2.0f, nullptr, &TubeLight::half_axis}, {"radius", "m", 1.0f, &TubeLight::radius}}};
    static constexpr std::array<NamedShape<TubeLight>, 1> shapes{{{"tube", dimensions}}};

    std::span<const Dimension<TubeLight>> sizes() const { return dimensions; }
    float area() const { return 4.0f * pi * radius * (radius + glm::length(half_axis)); } // [m²]
    /// Φ = π A L, as each element's is; I across the axis is L times the projection, a stadium of 4 r h + π
    /// r² for the half length h.
    Radiator radiator() const;
    Bounds bounds() const;
    void transform(const Motion& by);
    std::optional<LightSurface> surface() const;
    /// Uniform over the volume.
    EmitterPoint sample_point(vec3 u) const;
    EmitterPoint middle() const;
};

} // namespace sr::scene
