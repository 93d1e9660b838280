#include "scene/rig.hpp"

#include <algorithm>
#include <array>

namespace sr::scene {
namespace {

struct Softbox {
    const char* name;
    vec3 direction; // from the subject: to the right of the camera, up, towards the camera
    float distance; // in radii of the subject
    float edge;     // in radii of the subject
    float E;        // at the subject's centre, facing the softbox [lx]
};

constexpr std::array<Softbox, 3> softboxes{{
    {"key", {-0.8f, 0.9f, 0.9f}, 4.0f, 4.0f, 1000.0f},
    {"fill", {1.0f, 0.1f, 0.5f}, 4.0f, 6.0f, 500.0f},
    {"rim", {0.4f, 0.9f, -0.8f}, 4.0f, 4.0f, 800.0f},
}};

} // namespace

std::vector<RectangleLight> studio_rig(const Bounds& subject, const Camera& camera) {
    const float radius = std::max(subject.radius(), 1e-6f); // a subject without extent still gets lights
    const mat3 world_from_camera(camera.world_from_camera);
    const vec3 up = world_from_camera[1];
    std::vector<RectangleLight> lights;
    for (const Softbox& softbox : softboxes) {
        const vec3 outward = glm::normalize(world_from_camera * softbox.direction);
        const vec3 u = glm::normalize(glm::cross(up, -outward));
        const vec3 v = glm::cross(-outward, u);
        const float half_edge = 0.5f * softbox.edge * radius;
        RectangleLight light;
        light.name = softbox.name;
        light.center = subject.center() + softbox.distance * radius * outward;
        light.half_u = half_edge * u;
        light.half_v = half_edge * v;
        // E = L A / d² on the axis, for an emitter that is small against its distance; "about" is all that is
        // promised.
        light.L = vec3(softbox.E * softbox.distance * softbox.distance / (softbox.edge * softbox.edge));
        light.is_visible = false;
        light.passes_back_faces = true;
        lights.push_back(light);
    }
    return lights;
}

} // namespace sr::scene
