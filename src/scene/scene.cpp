#include "scene/scene.hpp"

namespace sr::scene {

void Bounds::extend(vec3 point) {
    min = glm::min(min, point);
    max = glm::max(max, point);
}

Bounds bounds_of(const Scene& scene) {
    Bounds bounds;
    for (const Instance& instance : scene.instances)
        for (vec3 position : scene.meshes[instance.mesh].positions)
            bounds.extend(vec3(instance.world_from_object * vec4(position, 1.0f)));
    return bounds;
}

std::size_t triangle_count(const Scene& scene) {
    std::size_t count = 0;
    for (const Instance& instance : scene.instances) count += scene.meshes[instance.mesh].indices.size() / 3;
    return count;
}

} // namespace sr::scene
