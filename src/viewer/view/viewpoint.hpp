#pragma once
// Viewpoint of a free camera, and functions that move it. Plain data.
#include "scene/look_at.hpp"

namespace sr::viewer {

/// A camera that turns around a pivot. Angles in radians, lengths in metres.
struct Viewpoint {
    vec3 pivot{0.0f};
    quat turn{1.0f, 0.0f, 0.0f, 0.0f}; // world from camera
    float distance = 5.0f;             // from the pivot to the eye, above 0
    float yfov = 0.6f; // full vertical angle; where it is orthographic, that of the same height
                       // at the pivot
    bool is_orthographic = false;

    vec3 right() const { return turn * vec3(1.0f, 0.0f, 0.0f); }
    vec3 up() const { return turn * vec3(0.0f, 1.0f, 0.0f); }
    vec3 back() const { return turn * vec3(0.0f, 0.0f, 1.0f); }
    vec3 eye() const { return pivot + distance * back(); }
    float half_height() const; // of what is seen at the pivot
};

/// The same view as a look-at description, which makes the camera.
scene::LookAt look_at(const Viewpoint& view);
Viewpoint viewpoint_of(const scene::LookAt& view);

/// The view of a camera in a picture of this width / height. The pivot is the point of the view axis that is
/// closest to `center`, or a point a little in front of the eye.
Viewpoint viewpoint_of(const scene::Camera& camera, float aspect_ratio, vec3 center);

/// Orbits around the pivot: `angles.x` around the world's Y, `angles.y` over the top. Positive x moves the
/// scene to the right, positive y downwards.
void orbit(Viewpoint& view, vec2 angles);

/// Turns the view around the eye.
void look_around(Viewpoint& view, vec2 angles);

/// Moves the scene with the pointer: `by` in heights of the picture, x to the right, y downwards.
void pan(Viewpoint& view, vec2 by);

/// Multiplies the distance to the pivot.
void dolly(Viewpoint& view, float factor);

/// Multiplies the distance to the point, which stays where it is in the picture.
void dolly_to(Viewpoint& view, float factor, vec3 point);

/// Turns the picture around its centre; positive turns the scene clockwise.
void roll(Viewpoint& view, float angle);

/// Removes roll. A view straight up or down does not change.
void level(Viewpoint& view);

/// Moves eye and pivot by metres along the camera's axes: x right, y up, z back.
void walk(Viewpoint& view, vec3 by);

/// Frames the bounding sphere of `bounds` in a picture of this width / height. Empty bounds change nothing.
void frame(Viewpoint& view, const scene::Bounds& bounds, float aspect_ratio);

/// Looks along an axis of the world: from the front, right, top and their opposites.
enum class Side { front, back, right, left, top, bottom };
void face(Viewpoint& view, Side side);

/// Returns the place of a point in a picture: x, y from 0 at the upper left to 1; absent behind the camera.
std::optional<vec2> projected(const scene::Camera& camera, float aspect_ratio, vec3 point);

struct PickRay {
    vec3 origin{0.0f};
    vec3 direction{0.0f, 0.0f, -1.0f}; // unit
};

/// The ray through a place of the picture, x, y from 0 at the upper left to 1.
PickRay ray_through(const scene::Camera& camera, float aspect_ratio, vec2 place);

} // namespace sr::viewer
