#pragma once
// A spot light.
#include "scene/lights/emitter.hpp"

#include <array>

namespace sr::scene {

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

} // namespace sr::scene
