#pragma once
// Three arrows at a light, by which the pointer moves it along an axis of the world.
#include "viewer/viewpoint.hpp"

#include <array>

namespace sr::viewer {

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

struct Arrow {
    vec2 from{0.0f}, to{0.0f}; // in the window
    int axis = 0;
};

/// The arrows at a point, as long on the screen wherever it is; absent behind the eye.
std::optional<std::array<Arrow, 3>> arrows_at(vec3 center, const Projection& projection, float pixels);

/// The arrow that the pointer is on; absent: none.
std::optional<int> axis_under(vec2 pointer, const std::array<Arrow, 3>& arrows);

/// How far along the axis through `center` the pointer is [m]: where the two lines are closest.
float along_axis(vec3 center, int axis, const Ray& pointer);

} // namespace sr::viewer
