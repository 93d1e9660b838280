#pragma once
// Where things of the scene are in the window, and what the pointer means there.
#include "viewer/viewpoint.hpp"

#include <array>

namespace sr::viewer {

/// The unit vector along an axis of the world.
vec3 axis_direction(int axis);

/// A change of the world around a point that stays.
mat4 around(vec3 center, const mat4& change);

/// How the picture lies in the window.
struct Projection {
    const scene::Camera& camera;
    float aspect_ratio = 1.0f;
    vec2 window{1.0f}; // its size, in the pointer's unit

    std::optional<vec2> operator()(vec3 point) const; // where in the window
    Ray ray(vec2 at) const { return ray_through(camera, aspect_ratio, at / window); }
};

/// How long so many pixels are at a point, across the view [m]; absent behind the eye.
std::optional<float> metres_of(vec3 point, const Projection& projection, float pixels);

/// Of the rings by which lights are turned [pixels].
inline constexpr float ring_radius = 90.0f;

struct Arrow {
    vec2 from{0.0f}, to{0.0f}; // in the window
    int axis = 0;
};

/// The arrows at a point, as long on the screen wherever it is; absent behind the eye.
std::optional<std::array<Arrow, 3>> arrows_at(vec3 center, const Projection& projection, float pixels);

/// How far along the line through `center` the pointer is [m]: where the two lines are closest. `along` is
/// unit.
float along_line(vec3 center, vec3 along, const Ray& pointer);
float along_axis(vec3 center, int axis, const Ray& pointer);

/// From p to the nearest point between a and b.
float distance_to_segment(vec2 p, vec2 a, vec2 b);

} // namespace sr::viewer
