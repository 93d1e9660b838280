#pragma once
// Cameras as glTF has them: at the origin of their own space, looking along -Z, +Y up.
#include "core/math.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
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

/// Axis that a camera goes around: one of the scene, whose y is up, or what is up in the camera's picture.
enum class TurnAxis { x, y, z, camera };

/// Returns the rotation by an angle around an axis, counter-clockwise for someone whom the axis points to:
/// for y, seen from above. `camera`: the one that the axis may belong to.
inline mat3 rotation_about(TurnAxis axis, const mat4& world_from_camera, double degrees) {
    const glm::dvec3 direction = axis == TurnAxis::x   ? glm::dvec3(1, 0, 0)
                                 : axis == TurnAxis::y ? glm::dvec3(0, 1, 0)
                                 : axis == TurnAxis::z ? glm::dvec3(0, 0, 1)
                                                       : glm::dvec3(world_from_camera[1]);
    return mat3(glm::rotate(glm::dmat4(1.0), degrees * (std::numbers::pi / 180.0), direction));
}

/// Returns the camera turned by an angle around an axis through a point.
inline Camera turned(Camera camera, vec3 around, double degrees, TurnAxis axis = TurnAxis::y) {
    mat4& m = camera.world_from_camera;
    const mat3 turn = rotation_about(axis, m, degrees);
    for (int column = 0; column < 3; ++column) m[column] = vec4(turn * vec3(m[column]), 0.0f);
    m[3] = vec4(around + turn * (vec3(m[3]) - around), 1.0f);
    return camera;
}

} // namespace sr::scene
