#pragma once
// A point light, alone or with a photometric profile.
#include "scene/lights/emitter.hpp"

#include <array>

namespace sr::scene {

/// Emits the intensity I in every direction, or the intensities that a profile gives.
struct PointLight {
    static constexpr std::string_view kind = "point";

    std::string name;
    vec3 position{0.0f};                                  // [m]
    vec3 I{1.0f};                                         // intensity [cd]; with a profile: its factor [1]
    float range = std::numeric_limits<float>::infinity(); // [m], KHR_lights_punctual's window
    float radius = 0.0f; // [m]; above 0 a sphere of radiance I / (π radius²) in the direction of each ray
    int profile = -1;    // index into Scene::profiles; negative: none
    /// Orthonormal: to the world from the axes that the profile is told in.
    mat3 world_from_profile{1.0f};
    bool is_visible = true; // false: the camera does not see the sphere

    static constexpr std::array<Dimension<PointLight>, 1> dimensions{
        {{"radius", "m", 1.0f, &PointLight::radius}}};

    bool has_extent() const { return radius > 0.0f; }
    /// Returns I from Φ (Φ / 4π) or from itself; with a radius also from the radiance of its sphere, L π
    /// radius². Absent: the quantity does not determine it. Without a profile.
    std::optional<double> quantity_from(Quantity quantity, double value) const;
    vec3 flux(const std::vector<LightProfile>& profiles) const; // [lm]
    Bounds bounds() const;
    void transform(const Motion& by);
    /// Its sphere; absent with a profile, whose radiance depends on the direction.
    std::optional<LightSurface> surface() const;
    EmitterPoint sample_point(vec3 u) const;
    EmitterPoint middle() const;
};

} // namespace sr::scene
