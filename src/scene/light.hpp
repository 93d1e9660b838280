#pragma once
// Emitters in world space, each in its own unit. Colours are folded into the quantity: I, E and L are RGB.
// A photometric scene (glTF) counts in cd, lx and cd/m²; a radiometric one in W/sr, W/m² and W/(m² sr).
#include "core/math.hpp"

#include <array>
#include <limits>
#include <string>
#include <variant>
#include <vector>

namespace sr::scene {

/// Emits the intensity I in every direction, or the intensities that a profile gives.
struct PointLight {
    std::string name;
    vec3 position{0.0f};                                  // [m]
    vec3 I{1.0f};                                         // intensity [cd]; with a profile: its factor [1]
    float range = std::numeric_limits<float>::infinity(); // [m], KHR_lights_punctual's window
    float radius = 0.0f; // [m]; above 0 a sphere of radiance I / (π radius²) in the direction of each ray
    int profile = -1;    // index into Scene::profiles; negative: none
    /// Orthonormal: to the world from the axes that the profile is told in.
    mat3 world_from_profile{1.0f};
    bool is_visible = true; // false: the camera does not see the sphere
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
    float outer_angle = pi / 4.0f; // half angle [rad], >= inner_angle; equal: a hard edge
    float radius = 0.0f;           // [m], as a point light's
    bool is_visible = true;
};

/// The falloff of a spot as saturate(scale · cosθ + offset)², θ from its axis (KHR_lights_punctual, "Inner
/// and Outer Cone Angles"). A hard edge is a ramp of a millionth in cosθ, inside the outer angle.
struct ConeFalloff {
    float scale = 0.0f;
    float offset = 0.0f;
};
ConeFalloff cone_falloff(const SpotLight& light);

/// Light from infinitely far: parallel, or from a disk in the sky (the sun's angular radius is 4.65 mrad).
struct DirectionalLight {
    std::string name;
    vec3 direction{0.0f, 0.0f, -1.0f}; // unit, where the light goes
    vec3 E{1.0f};                      // irradiance on a surface that faces the light [lx]
    float angular_radius = 0.0f;       // [rad], below π/2; the disk's radiance is E / (π sin²)
};

/// Which part of a texture an emitter's plane shows: at center + s*half_u + t*half_v it reads
/// uv = origin + s*along_u + t*along_v. The texel multiplies L.
struct EmissionMap {
    int texture = -1; // index into Scene::textures; negative: none
    vec2 origin{0.5f, 0.5f};
    vec2 along_u{0.5f, 0.0f};
    vec2 along_v{0.0f, -0.5f}; // a picture's first row is its top

    bool is_present() const { return texture >= 0; }
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
    EmissionMap map{};
    bool passes_back_faces = false; // see passes_back_faces() below

    float area() const { return 4.0f * glm::length(glm::cross(half_u, half_v)); } // [m²]
    vec3 normal() const { return glm::normalize(glm::cross(half_u, half_v)); }
};

/// A disk or an ellipse: the points center + s*half_u + t*half_v for s² + t² <= 1. Front as a rectangle's.
struct DiskLight {
    std::string name;
    vec3 center{0.0f};             // [m]
    vec3 half_u{1.0f, 0.0f, 0.0f}; // a semi-axis [m]
    vec3 half_v{0.0f, 1.0f, 0.0f}; // the other [m], perpendicular to half_u
    vec3 L{1.0f};                  // radiance [cd/m²]
    bool is_two_sided = false;
    bool is_visible = true;
    EmissionMap map{};

    float area() const { return pi * glm::length(glm::cross(half_u, half_v)); } // [m²]
    vec3 normal() const { return glm::normalize(glm::cross(half_u, half_v)); }
};

/// Emits the radiance L outwards.
struct SphereLight {
    std::string name;
    vec3 center{0.0f};   // [m]
    float radius = 0.1f; // [m]
    vec3 L{1.0f};        // radiance [cd/m²]
    bool is_visible = true;

    float area() const { return 4.0f * pi * radius * radius; } // [m²]
};

/// A capsule, all points within `radius` of the axis from center - half_axis to center + half_axis: a tube
/// with round ends. Emits the radiance L outwards.
struct TubeLight {
    std::string name;
    vec3 center{0.0f};                // [m]
    vec3 half_axis{0.5f, 0.0f, 0.0f}; // [m]
    float radius = 0.02f;             // [m]
    vec3 L{1.0f};                     // radiance [cd/m²]
    bool is_visible = true;

    float area() const { // [m²]
        return 4.0f * pi * radius * (radius + glm::length(half_axis));
    }
};

/// A flat convex polygon. Emits the radiance L on the side from which its corners go counter-clockwise.
struct PolygonLight {
    std::string name;
    std::vector<vec3> corners; // [m], three or more
    vec3 L{1.0f};              // radiance [cd/m²]
    bool is_two_sided = false;
    bool is_visible = true;

    float area() const; // [m²]
    vec3 normal() const;
    vec3 center() const; // the mean of the corners
};

/// Emissive triangles, each an emitter of its own, taken together.
struct MeshLight {
    struct Triangle {
        std::array<vec3, 3> corners; // [m], counter-clockwise seen from the front
        std::array<vec2, 3> uv;      // where a texture is read
    };
    std::string name;
    std::vector<Triangle> triangles; // none without area
    vec3 L{1.0f};                    // radiance [cd/m²], times the texture
    bool is_two_sided = false;
    int texture = -1; // index into Scene::textures; negative: none

    float area() const; // [m²]
};

using Light = std::variant<PointLight, SpotLight, DirectionalLight, RectangleLight, DiskLight, SphereLight,
                           TubeLight, PolygonLight, MeshLight>;

/// Whether a single-sided face that the light meets from behind casts no shadow of it. So it is for lights
/// that stand in for the surroundings of a model: what the camera looks through, they shine through. Other
/// lights are blocked by both sides of every face. A kind of light says so by a member of this name.
bool passes_back_faces(const Light& light);

} // namespace sr::scene
