#pragma once
// A camera in words that a person can copy, keep and paste: "eye=0,1,4;target=0,1,0;fov=40".
#include "scene/scene.hpp"

#include <string_view>

namespace sr::scene {

/// Where a camera stands, what it looks at, what points up in its picture.
struct LookAt {
    vec3 eye{0.0f, 0.0f, 1.0f};       // [m]
    vec3 target{0.0f};                // [m], not the eye
    vec3 up{0.0f, 1.0f, 0.0f};        // any length; not along the view
    float yfov = 0.8f;                // full vertical angle [rad], glTF's yfov
    std::optional<float> ymag;        // half the height of an orthographic picture [m]; absent: perspective
    std::optional<float> znear, zfar; // [m]; absent: chosen by the scene's bounds
    /// Scene::origin, which eye and target are relative to. Texts are in the file's world.
    glm::dvec3 origin{0.0};

    bool operator==(const LookAt&) const = default;
};

/// The depth range of a picture [m].
struct DepthRange {
    float near = 0.01f;
    float far = 100.0f;
};

/// Returns a range that holds all of `bounds` that lies in front of the camera; a perspective one begins at a
/// ten-thousandth of where it ends, at least.
DepthRange depth_range(const LookAt& view, const Bounds& bounds);

/// The camera of a picture of the given width / height; the same LookAt is the same camera, to the last bit.
Camera camera_at(const LookAt& view, const Bounds& bounds, float aspect_ratio);

/// Returns whether the text is a LookAt rather than a camera's name: it contains "eye=" or "target=".
bool is_look_at(std::string_view text);

/// Reads "eye=X,Y,Z;target=X,Y,Z" with, if wanted, up=X,Y,Z (0,1,0), fov=DEGREES or yfov=RADIANS, ymag=METRES
/// (orthographic), near=METRES, far=METRES. `origin` is Scene::origin.
/// @throws Error that says which part is wrong
LookAt parse_look_at(std::string_view text, glm::dvec3 origin = glm::dvec3(0.0));

/// Returns a text that parse_look_at() reads back exactly.
std::string text_of(const LookAt& view);

} // namespace sr::scene
