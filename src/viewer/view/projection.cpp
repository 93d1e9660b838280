#include "viewer/view/projection.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>

namespace sr::viewer {
namespace {

struct Corners {
    vec3 a, b, c;
};

/// Möller & Trumbore 1997, "Fast, Minimum Storage Ray/Triangle Intersection": the distance along the ray in
/// its direction's length; negative where it passes by.
float distance_to(const Corners& t, const PickRay& ray) {
    constexpr float missed = -1.0f;
    const vec3 e1 = t.b - t.a, e2 = t.c - t.a;
    const vec3 p = glm::cross(ray.direction, e2);
    const float det = glm::dot(e1, p);
    if (det == 0.0f) return missed;
    const vec3 from = ray.origin - t.a;
    const float u = glm::dot(from, p) / det;
    if (!(u >= 0.0f && u <= 1.0f)) return missed;
    const vec3 q = glm::cross(from, e1);
    const float v = glm::dot(ray.direction, q) / det;
    if (!(v >= 0.0f && u + v <= 1.0f)) return missed;
    return glm::dot(e2, q) / det;
}

Corners corners_of(const scene::Mesh& mesh, std::size_t first) {
    return {mesh.positions[mesh.indices[first]], mesh.positions[mesh.indices[first + 1]],
            mesh.positions[mesh.indices[first + 2]]};
}

} // namespace

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
    return place ? std::optional(picture.from + *place * picture.size) : std::nullopt;
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

float along_axis(vec3 center, int axis, const PickRay& pointer) {
    return along_line(center, axis_direction(axis), pointer);
}

float along_line(vec3 center, vec3 a, const PickRay& pointer) {
    // The point of one line that is closest to another: both differences are perpendicular to both lines.
    const vec3 d = pointer.direction, w = center - pointer.origin;
    const float between = glm::dot(a, d);
    const float denominator = 1.0f - between * between;
    if (denominator < 1e-6f) return 0.0f; // the line points at the eye: no move of the pointer is along it
    return (between * glm::dot(d, w) - glm::dot(a, w)) / denominator;
}

std::optional<Hit> first_hit(const scene::Scene& scene, const PickRay& ray) {
    float nearest = std::numeric_limits<float>::infinity();
    std::optional<Hit> hit;
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        const scene::Instance& instance = scene.instances[i];
        if (instance.is_hidden) continue;
        const scene::Mesh& mesh = scene.meshes[static_cast<std::size_t>(instance.mesh)];
        // In object space with the direction's length kept, distances are the world's.
        const mat4 to_object = glm::inverse(instance.world_from_object);
        const PickRay local{vec3(to_object * vec4(ray.origin, 1.0f)),
                            vec3(to_object * vec4(ray.direction, 0.0f))};
        for (std::size_t t = 0; t + 2 < mesh.indices.size(); t += 3) {
            const Corners corners = corners_of(mesh, t);
            const float distance = distance_to(corners, local);
            if (!(distance > 0.0f && distance < nearest)) continue;
            nearest = distance;
            const vec3 n = glm::cross(corners.b - corners.a, corners.c - corners.a);
            vec3 world = glm::normalize(glm::transpose(mat3(to_object)) * n);
            if (glm::dot(world, ray.direction) > 0.0f) world = -world;
            hit = Hit{distance, ray.origin + distance * ray.direction, world, static_cast<int>(i)};
        }
    }
    return hit;
}

} // namespace sr::viewer
