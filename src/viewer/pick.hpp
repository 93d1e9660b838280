#pragma once
// What is under the pointer, found on the CPU: one ray against every triangle takes about a millisecond a
// hundred thousand of them, and needs nothing that must be kept up to date.
#include "scene/scene.hpp"
#include "viewer/viewpoint.hpp"

namespace sr::viewer {

struct Hit {
    float distance = 0.0f; // [m]
    vec3 point{0.0f};      // [m]
    vec3 normal{0.0f};     // of the triangle, towards the ray's origin
    int instance = 0;
};

/// The first surface along the ray; absent: none. Transparent surfaces count.
std::optional<Hit> first_hit(const scene::Scene& scene, const Ray& ray);

} // namespace sr::viewer
