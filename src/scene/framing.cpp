#include "scene/framing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sr::scene {

namespace {

/// How far the scene reaches along a direction, max p·direction over all vertices.
float reach(const Scene& scene, vec3 direction) {
    float farthest = -std::numeric_limits<float>::infinity();
    for (const Instance& instance : scene.instances) {
        const mat4& m = instance.world_from_object;
        const vec3 in_object = glm::transpose(mat3(m)) * direction;
        const float shift = glm::dot(vec3(m[3]), direction);
        for (const vec3 position : scene.meshes[instance.mesh].positions)
            farthest = std::max(farthest, glm::dot(position, in_object) + shift);
    }
    return farthest;
}

/// Where the eye is along one axis of the picture, and how far back it must be, for the planes that bound the
/// picture at ±tangent to touch the scene on both sides.
struct Fit {
    float along;
    float back;
};

Fit fitted(const Scene& scene, vec3 axis, vec3 back, float tangent) {
    const float plus = reach(scene, axis + tangent * back);
    const float minus = reach(scene, -axis + tangent * back);
    return {0.5f * (plus - minus), 0.5f * (plus + minus) / tangent};
}

} // namespace

Camera framing_camera(const Scene& scene, float aspect_ratio) {
    constexpr float yfov = 0.6f;    // [rad], about a 40 mm lens on a full frame
    constexpr float margin = 1.08f; // air around the subject
    const Bounds bounds = bounds_of(scene);
    const float radius = bounds.is_empty() ? 1.0f : std::max(bounds.radius(), 1e-6f);

    const vec3 back = glm::normalize(vec3(0.5f, 0.35f, 1.0f)); // from the subject to the camera
    const vec3 right = glm::normalize(glm::cross(vec3(0.0f, 1.0f, 0.0f), back));
    const vec3 up = glm::cross(back, right);

    const float tan_y = std::tan(0.5f * yfov) / margin;
    vec3 eye = 5.0f * back;
    float nearest = 4.0f, farthest = 6.0f;
    if (!bounds.is_empty()) {
        const Fit x = fitted(scene, right, back, tan_y * aspect_ratio);
        const Fit y = fitted(scene, up, back, tan_y);
        const float front = reach(scene, back);
        const float distance = std::max({x.back, y.back, front + 1e-3f * radius});
        eye = x.along * right + y.along * up + distance * back;
        nearest = distance - front;
        farthest = distance + reach(scene, -back);
    }
    Camera camera;
    camera.name = "auto";
    camera.world_from_camera = mat4(vec4(right, 0.0f), vec4(up, 0.0f), vec4(back, 0.0f), vec4(eye, 1.0f));
    camera.projection = Perspective{yfov, std::nullopt, 0.9f * nearest,
                                    farthest + 0.1f * (farthest - nearest) + 1e-3f * radius};
    return camera;
}

} // namespace sr::scene
