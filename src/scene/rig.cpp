#include "scene/rig.hpp"

#include <algorithm>
#include <array>
#include <cmath>

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

/// A panel on the sphere of directions, the camera at azimuth 0 and its right at 90° [degrees].
struct Panel {
    float azimuth, elevation; // of its middle
    float width, height;
    float edge; // over which it fades
    float L;    // relative to the others
};

constexpr std::array<Panel, 5> panels{{
    {-48.0f, 38.0f, 66.0f, 46.0f, 10.0f, 3.4f}, // key
    {62.0f, 12.0f, 44.0f, 74.0f, 14.0f, 1.3f},  // fill
    {-146.0f, 28.0f, 22.0f, 84.0f, 8.0f, 3.0f}, // strips
    {142.0f, 28.0f, 26.0f, 84.0f, 8.0f, 3.4f},
    {0.0f, 90.0f, 720.0f, 56.0f, 16.0f, 1.5f}, // ceiling
}};

/// From 0 to 1 as x goes from -0.5 to 0.5, with no kink.
float soft_step(float x) {
    const float t = std::clamp(x + 0.5f, 0.0f, 1.0f);
    return t * t * (3.0f - 2.0f * t);
}

float studio_radiance(vec3 w) {
    const float azimuth = glm::degrees(std::atan2(w.x, w.z)), elevation = glm::degrees(std::asin(w.y));
    float L = glm::mix(0.22f, 0.62f, soft_step(0.5f * w.y)); // floor to ceiling
    for (const Panel& panel : panels) {
        const float around = std::abs(std::remainder(azimuth - panel.azimuth, 360.0f));
        const float along = std::abs(elevation - panel.elevation);
        L += panel.L * soft_step((0.5f * panel.width - around) / panel.edge)
             * soft_step((0.5f * panel.height - along) / panel.edge);
    }
    return L;
}

/// [cd/m²]
EnvironmentMap studio_map() {
    constexpr int width = 256, height = 128;
    const vec3 n = glm::normalize(vec3(0.0f, 0.35f, 1.0f)); // of the white that is 1
    std::vector<vec3> texels;
    double E = 0.0;
    for (int j = 0; j < height; ++j) {
        for (int i = 0; i < width; ++i) {
            const vec3 w = EnvironmentMap::direction_of(
                {(static_cast<float>(i) + 0.5f) / width, (static_cast<float>(j) + 0.5f) / height});
            texels.emplace_back(studio_radiance(w));
            const double solid_angle = 2.0 * pi * pi / (width * height) * std::sqrt(1.0 - w.y * w.y);
            E += solid_angle * std::max(glm::dot(n, w), 0.0f) * texels.back().x;
        }
    }
    for (vec3& L : texels) L *= static_cast<float>(pi / E);
    return {width, height, std::move(texels)};
}

} // namespace

EnvironmentLight studio(const Camera& camera) {
    static const auto map = std::make_shared<const EnvironmentMap>(studio_map());
    EnvironmentLight light;
    light.name = "studio";
    light.map = map;
    const vec3 back = glm::cross(vec3(camera.world_from_camera[0]), vec3(0.0f, 1.0f, 0.0f));
    light.rotation = std::atan2(back.x, back.z); // the map's +Z is where the camera stands
    light.is_visible = false;
    light.passes_back_faces = true;
    return light;
}

std::vector<RectangleLight> softbox_rig(const Bounds& subject, const Camera& camera) {
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
