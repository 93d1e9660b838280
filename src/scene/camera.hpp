#pragma once
// Cameras as glTF has them: at the origin of their own space, looking along -Z, +Y up.
#include "core/math.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
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

/// Returns the camera turned by an angle around the upright axis through a point: counter-clockwise, seen
/// from above.
inline Camera turned(Camera camera, vec3 around, double degrees) {
    const double angle = degrees * (std::numbers::pi / 180.0);
    const auto c = static_cast<float>(std::cos(angle)), s = static_cast<float>(std::sin(angle));
    const mat3 turn(vec3(c, 0.0f, -s), vec3(0.0f, 1.0f, 0.0f), vec3(s, 0.0f, c));
    mat4& m = camera.world_from_camera;
    for (int axis = 0; axis < 3; ++axis) m[axis] = vec4(turn * vec3(m[axis]), 0.0f);
    m[3] = vec4(around + turn * (vec3(m[3]) - around), 1.0f);
    return camera;
}

} // namespace sr::scene
