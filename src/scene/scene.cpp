#include "scene/scene.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

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

bool is_closed(const Mesh& mesh) {
    std::map<std::array<float, 3>, int> places;
    std::vector<int> place_of; // of each vertex
    for (const vec3 p : mesh.positions)
        place_of.push_back(places.try_emplace({p.x, p.y, p.z}, static_cast<int>(places.size())).first->second);
    std::map<std::pair<int, int>, int> balance; // of each edge: in its sense less in the other
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
        for (std::size_t k = 0; k < 3; ++k) {
            const int a = place_of[mesh.indices[i + k]], b = place_of[mesh.indices[i + (k + 1) % 3]];
            if (a != b) balance[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
        }
    for (const auto& [edge, surplus] : balance)
        if (surplus != 0) return false;
    return !balance.empty();
}

bool is_body_of_glass(const Mesh& mesh, const Material& material) {
    return material.is_transmissive() && material.thickness > 0.0f && is_closed(mesh);
}

} // namespace sr::scene
