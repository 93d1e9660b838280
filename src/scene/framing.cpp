#include "scene/framing.hpp"

#include <algorithm>
#include <cmath>

namespace sr::scene {

Camera framing_camera(const Bounds& subject, float aspect_ratio) {
    constexpr float yfov = 0.6f;    // [rad], about a 55 mm lens on a full frame
    constexpr float margin = 1.08f; // air around the subject
    const vec3 center = subject.is_empty() ? vec3(0.0f) : subject.center();
    const float radius = subject.is_empty() ? 1.0f : std::max(subject.radius(), 1e-6f);

    const vec3 back = glm::normalize(vec3(0.5f, 0.35f, 1.0f)); // from the subject to the camera
    const vec3 right = glm::normalize(glm::cross(vec3(0.0f, 1.0f, 0.0f), back));
    const vec3 up = glm::cross(back, right);

    const float tan_y = std::tan(0.5f * yfov) / margin;
    const float tan_x = tan_y * aspect_ratio;
    float distance = subject.is_empty() ? 5.0f : 0.0f;
    for (int corner = 0; corner < 8 && !subject.is_empty(); ++corner) {
        const vec3 p(corner & 1 ? subject.max.x : subject.min.x, corner & 2 ? subject.max.y : subject.min.y,
                     corner & 4 ? subject.max.z : subject.min.z);
        const vec3 d = p - center;
        const float reach = std::max(std::abs(glm::dot(d, right)) / tan_x, std::abs(glm::dot(d, up)) / tan_y);
        distance = std::max(distance, reach + glm::dot(d, back));
    }
    distance = std::max(distance, 1e-3f * radius);

    Camera camera;
    camera.name = "auto";
    camera.world_from_camera =
        mat4(vec4(right, 0.0f), vec4(up, 0.0f), vec4(back, 0.0f), vec4(center + distance * back, 1.0f));
    camera.projection = Perspective{yfov, std::nullopt, std::max(distance - 1.5f * radius, 0.01f * distance),
                                    distance + 1.5f * radius};
    return camera;
}

} // namespace sr::scene
