#pragma once
// Emitters in world space, each in its own unit. Colours are folded into the quantity: I, E and L are RGB.
// A photometric scene (glTF) counts in cd, lx and cd/m²; a radiometric one in W/sr, W/m² and W/(m² sr).
#include "core/math.hpp"

#include <limits>
#include <string>
#include <variant>

namespace sr::scene {

/// Emits the intensity I in every direction.
struct PointLight {
    std::string name;
    vec3 position{0.0f};                                  // [m]
    vec3 I{1.0f};                                         // intensity [cd]
    float range = std::numeric_limits<float>::infinity(); // [m], KHR_lights_punctual's window
};

/// A point light within a cone. KHR_lights_punctual: full intensity up to the inner angle, none beyond the
/// outer.
struct SpotLight {
    std::string name;
    vec3 position{0.0f};
    vec3 direction{0.0f, 0.0f, -1.0f}; // unit, where the light goes
    vec3 I{1.0f};                      // on the axis [cd]
    float range = std::numeric_limits<float>::infinity();
    float inner_angle = 0.0f;      // half angle [rad]
    float outer_angle = pi / 4.0f; // half angle [rad], > inner_angle
};

/// Parallel light from infinitely far.
struct DirectionalLight {
    std::string name;
    vec3 direction{0.0f, 0.0f, -1.0f}; // unit, where the light goes
    vec3 E{1.0f};                      // irradiance on a surface that faces the light [lx]
};

/// A flat emitter: the points center + s*half_u + t*half_v for s, t in [-1, 1].
/// It emits the radiance L, the same in all directions on the side of cross(half_u, half_v).
struct RectangleLight {
    std::string name;
    vec3 center{0.0f};             // [m]
    vec3 half_u{1.0f, 0.0f, 0.0f}; // half an edge [m]
    vec3 half_v{0.0f, 1.0f, 0.0f}; // half the other edge [m], perpendicular to half_u
    vec3 L{1.0f};                  // radiance [cd/m²]
    bool is_two_sided = false;
    bool is_visible = true; // false: it lights the scene but the camera does not see it

    float area() const { return 4.0f * glm::length(glm::cross(half_u, half_v)); } // [m²]
    vec3 normal() const { return glm::normalize(glm::cross(half_u, half_v)); }
};

using Light = std::variant<PointLight, SpotLight, DirectionalLight, RectangleLight>;

} // namespace sr::scene
