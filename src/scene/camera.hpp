#pragma once
// Cameras as glTF has them: at the origin of their own space, looking along -Z, +Y up.
#include "core/math.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <variant>

namespace sr::scene {

struct Perspective {
    float yfov = 0.8f;                 // full vertical angle [rad]
    std::optional<float> aspect_ratio; // width / height, where the file fixes one
    float znear = 0.01f;               // [m], > 0
    std::optional<float> zfar;         // [m]; absent: infinitely far
};

struct Orthographic {
    float xmag = 1.0f; // half the width [m]
    float ymag = 1.0f; // half the height [m]
    float znear = 0.0f;
    float zfar = 100.0f;
};

struct Camera {
    std::string name;
    mat4 world_from_camera{1.0f}; // rotation and translation only
    std::variant<Perspective, Orthographic> projection;
    int number = -1; // among the cameras of its file, those that are off at the moment included; negative:
                     // its place in Scene::cameras

    /// Width / height of the picture that the camera asks for, if it does.
    std::optional<float> aspect_ratio() const {
        if (const auto* p = std::get_if<Perspective>(&projection)) return p->aspect_ratio;
        const auto& o = std::get<Orthographic>(projection);
        return o.xmag / o.ymag;
    }
};

/// Half of what a picture of the given width / height shows: at unit distance for a perspective camera [1],
/// else in metres. The whole of the camera's own frame is in the picture: where their shapes differ, more is
/// seen at the sides.
inline vec2 half_extent(const Camera& camera, float aspect) {
    vec2 own;
    if (const auto* p = std::get_if<Perspective>(&camera.projection)) {
        own.y = std::tan(0.5f * p->yfov);
        own.x = own.y * p->aspect_ratio.value_or(aspect);
    } else {
        const auto& o = std::get<Orthographic>(camera.projection);
        own = {o.xmag, o.ymag};
    }
    return {std::max(own.x, own.y * aspect), std::max(own.y, own.x / aspect)};
}

} // namespace sr::scene
