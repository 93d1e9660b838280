#pragma once
// Point lights, spots and directional lights: those of KHR_lights_punctual, with a size where they have one.
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

/// The falloff of a spot as saturate(scale · cosθ + offset)², θ from its axis (KHR_lights_punctual, "Inner
/// and Outer Cone Angles"). A hard edge is a ramp of a millionth in cosθ, inside the outer angle.
struct ConeFalloff {
    float scale = 0.0f;
    float offset = 0.0f;
};

/// A point light within a cone. KHR_lights_punctual: full intensity up to the inner angle, none beyond the
/// outer.
struct SpotLight {
    static constexpr std::string_view kind = "spot";

    std::string name;
    vec3 position{0.0f};
    vec3 direction{0.0f, 0.0f, -1.0f}; // unit, where the light goes
    vec3 I{1.0f};                      // on the axis [cd]
    float range = std::numeric_limits<float>::infinity();
    float inner_angle = 0.0f;      // half angle [rad]
    float outer_angle = pi / 4.0f; // half angle [rad], >= inner_angle; equal: a hard edge
    float radius = 0.0f;           // [m], as a point light's
    bool is_visible = true;

    static constexpr std::array<Dimension<SpotLight>, 1> dimensions{
        {{"radius", "m", 1.0f, &SpotLight::radius}}};

    bool has_extent() const { return radius > 0.0f; }
    ConeFalloff falloff() const;
    /// ∫ falloff dω [sr]. With c = cosθ, w = cos inner - cos outer:
    /// 2π ((1 - cos inner) + ∫₀^w (t/w)² dt) = 2π (1 - cos inner + w / 3). A hard cone's is 2π (1 - cos
    /// outer).
    double solid_angle() const;
    /// Returns I on the axis from Φ (Φ / solid_angle()) or from itself; with a radius also from the radiance
    /// on the axis. Absent: the quantity does not determine it.
    std::optional<double> quantity_from(Quantity quantity, double value) const;
    vec3 flux(const std::vector<LightProfile>& profiles) const; // [lm]
    Bounds bounds() const;
    void transform(const Motion& by);
    EmitterPoint sample_point(vec3 u) const;
    EmitterPoint middle() const;
};

/// Light from infinitely far: parallel, or from a disk in the sky (the sun's angular radius is 4.65 mrad).
struct DirectionalLight {
    static constexpr std::string_view kind = "directional";

    std::string name;
    vec3 direction{0.0f, 0.0f, -1.0f}; // unit, where the light goes
    vec3 E{1.0f};                      // irradiance on a surface that faces the light [lx]
    float angular_radius = 0.0f;       // [rad], below π/2; the disk's radiance is E / (π sin²)

    static constexpr std::array<Dimension<DirectionalLight>, 1> dimensions{
        {{"angular_diameter", "rad", 2.0f, &DirectionalLight::angular_radius}}};

    bool has_extent() const { return angular_radius > 0.0f; }
    /// Returns E from itself, or where the light is a disk from its radiance, E = π L sin²(angular radius).
    /// Absent: the quantity does not determine it. What flux a parallel beam carries depends on how wide a
    /// scene it lights.
    std::optional<double> quantity_from(Quantity quantity, double value) const;
    void transform(const Motion& by) { direction = glm::normalize(by.rotation * direction); }
    EmitterPoint sample_point(vec3 u) const;
    EmitterPoint middle() const { return sample_point(vec3(0.0f)); }
};

} // namespace sr::scene
