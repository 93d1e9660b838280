#include "viewer/gizmo.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace sr::viewer {
vec3 axis_direction(int axis) {
    vec3 direction(0.0f);
    direction[axis] = 1.0f;
    return direction;
}

mat4 around(vec3 center, const mat4& change) {
    return glm::translate(mat4(1.0f), center) * change * glm::translate(mat4(1.0f), -center);
}

std::optional<vec2> Projection::operator()(vec3 point) const {
    const auto place = projected(camera, aspect_ratio, point);
    return place ? std::optional(*place * window) : std::nullopt;
}

std::optional<float> metres_of(vec3 point, const Projection& projection, float pixels) {
    const vec3 right = glm::normalize(vec3(projection.camera.world_from_camera[0]));
    const auto from = projection(point), metre = projection(point + right);
    if (!from || !metre) return std::nullopt;
    const float scale = glm::distance(*metre, *from);
    return scale > 0.0f ? std::optional(pixels / scale) : std::nullopt;
}

std::optional<std::array<Arrow, 3>> arrows_at(vec3 center, const Projection& projection, float pixels) {
    const auto from = projection(center);
    const auto length = metres_of(center, projection, pixels);
    if (!from || !length) return std::nullopt;
    std::array<Arrow, 3> arrows;
    for (int axis = 0; axis < 3; ++axis) {
        const auto to = projection(center + *length * axis_direction(axis));
        if (!to) return std::nullopt;
        arrows[static_cast<std::size_t>(axis)] = {*from, *to, axis};
    }
    return arrows;
}

float distance_to_segment(vec2 p, vec2 a, vec2 b) {
    const vec2 along = b - a;
    const float length = glm::dot(along, along);
    const float t = length > 0.0f ? std::clamp(glm::dot(p - a, along) / length, 0.0f, 1.0f) : 0.0f;
    return glm::distance(p, a + t * along);
}

float along_axis(vec3 center, int axis, const Ray& pointer) {
    return along_line(center, axis_direction(axis), pointer);
}

float along_line(vec3 center, vec3 a, const Ray& pointer) {
    // The point of one line that is closest to another: both differences are perpendicular to both lines.
    const vec3 d = pointer.direction, w = center - pointer.origin;
    const float between = glm::dot(a, d);
    const float denominator = 1.0f - between * between;
    if (denominator < 1e-6f) return 0.0f; // the line points at the eye: no move of the pointer is along it
    return (between * glm::dot(d, w) - glm::dot(a, w)) / denominator;
}

} // namespace sr::viewer
