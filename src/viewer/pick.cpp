#include "viewer/pick.hpp"

#include <cmath>
#include <limits>

namespace sr::viewer {
namespace {

struct Corners {
    vec3 a, b, c;
};

/// Möller & Trumbore 1997, "Fast, Minimum Storage Ray/Triangle Intersection": the distance along the ray in
/// its direction's length; negative where it passes by.
float distance_to(const Corners& t, const Ray& ray) {
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

std::optional<Hit> first_hit(const scene::Scene& scene, const Ray& ray) {
    float nearest = std::numeric_limits<float>::infinity();
    std::optional<Hit> hit;
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        const scene::Instance& instance = scene.instances[i];
        const scene::Mesh& mesh = scene.meshes[static_cast<std::size_t>(instance.mesh)];
        // In object space with the direction's length kept, distances are the world's.
        const mat4 to_object = glm::inverse(instance.world_from_object);
        const Ray local{vec3(to_object * vec4(ray.origin, 1.0f)),
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
