#pragma once
// A directional light, parallel or from a disk in the sky.
#include "scene/lights/emitter.hpp"

#include <array>

namespace sr::scene {

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
