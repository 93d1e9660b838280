#pragma once
// A spherical light.
#include "scene/lights/emitter.hpp"

#include <array>

namespace sr::scene {

/// Emits the radiance L outwards.
struct SphereLight {
    static constexpr std::string_view kind = "sphere";

    std::string name;
    vec3 center{0.0f};   // [m]
    float radius = 0.1f; // [m]
    vec3 L{1.0f};        // radiance [cd/m²]
    bool is_visible = true;

    static constexpr std::array<Dimension<SphereLight>, 1> dimensions{
        {{"radius", "m", 1.0f, &SphereLight::radius}}};
    static constexpr std::array<NamedShape<SphereLight>, 1> shapes{{{"sphere", dimensions}}};

    std::span<const Dimension<SphereLight>> sizes() const { return dimensions; }
    float area() const { return 4.0f * pi * radius * radius; } // [m²]
    /// Φ = π A L, as each element's is; I = L π r² in every direction.
    Radiator radiator() const;
    Bounds bounds() const;
    void transform(const Motion& by);
    std::optional<LightSurface> surface() const;
    EmitterPoint sample_point(vec3 u) const;
    EmitterPoint middle() const;
};

} // namespace sr::scene
