#pragma once
// Projection between the scene and the window: where points are drawn, what the pointer points at.
#include "scene/scene.hpp"
#include "viewer/app/layout.hpp"
#include "viewer/view/viewpoint.hpp"

#include <array>

namespace sr::viewer {

inline constexpr std::array axis_names{"X", "Y", "Z"};

/// Unit vector along an axis of the world.
vec3 axis_direction(int axis);

/// A transformation of the world with a fixed point `center`.
mat4 around(vec3 center, const mat4& change);

/// Projection of a camera onto the window.
struct Projection {
    const scene::Camera& camera;
    float aspect_ratio = 1.0f;
    Area picture{vec2(0.0f), vec2(1.0f)}; // that shows it

    /// Place of a point in the window; absent behind the camera.
    std::optional<vec2> operator()(vec3 point) const;
    PickRay ray(vec2 at) const {
        return ray_through(camera, aspect_ratio, (at - picture.from) / picture.size);
    }
};

/// Length of so many pixels at a point, across the view [m]; absent behind the camera.
std::optional<float> metres_of(vec3 point, const Projection& projection, float pixels);

/// Radius of the rings that turn lights [pixels].
inline constexpr float ring_radius = 90.0f;

struct Arrow {
    vec2 from{0.0f}, to{0.0f}; // in the window
    int axis = 0;
};

/// Arrows along the axes at a point, `pixels` long; absent behind the camera.
std::optional<std::array<Arrow, 3>> arrows_at(vec3 center, const Projection& projection, float pixels);

/// Coordinate of the pointer on the line through `center` along the unit vector `along` [m], where the two
/// lines are closest.
float along_line(vec3 center, vec3 along, const PickRay& pointer);
float along_axis(vec3 center, int axis, const PickRay& pointer);

/// Distance of p to the segment from a to b.
float distance_to_segment(vec2 p, vec2 a, vec2 b);

struct Hit {
    float distance = 0.0f; // [m]
    vec3 point{0.0f};      // [m]
    vec3 normal{0.0f};     // of the triangle, towards the origin of the ray
    int instance = 0;
};

/// Finds the first surface along a ray, transparent ones included, by a test of every triangle: about a
/// millisecond for 100,000 triangles, and no acceleration structure to update.
std::optional<Hit> first_hit(const scene::Scene& scene, const PickRay& ray);

} // namespace sr::viewer
