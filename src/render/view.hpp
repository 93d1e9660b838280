#pragma once
// From a camera to the matrices of a frame.
#include "scene/camera.hpp"

namespace sr::render {

struct View {
    mat4 clip_from_world{1.0f};
    vec4 eye{0.0f}; // w = 1: the position of the camera; w = 0: the unit direction to it (orthographic)
};

/// The camera's view into a picture of width × height pixels. The whole of the camera's own frame is in the
/// picture: where the picture's shape differs, more is seen at its sides. `sub_pixel` in [0, 1)² says where
/// in each pixel the samples lie, (0.5, 0.5) being the centre; y points down, as in the picture.
View view_of(const scene::Camera& camera, int width, int height, vec2 sub_pixel);

} // namespace sr::render
