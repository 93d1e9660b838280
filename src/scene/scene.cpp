#include "scene/scene.hpp"

#include <algorithm>
#include <array>
#include <cmath>
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

namespace {

float median(std::vector<float> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

} // namespace

glm::dvec3 fitting_origin(const Scene& scene) {
    std::array<std::vector<float>, 3> centers;
    std::vector<float> radii;
    for (const Instance& instance : scene.instances) {
        Bounds bounds;
        for (const vec3 position : scene.meshes[instance.mesh].positions)
            bounds.extend(vec3(instance.world_from_object * vec4(position, 1.0f)));
        if (bounds.is_empty() || !std::isfinite(bounds.radius())) continue;
        for (int axis = 0; axis < 3; ++axis) centers[axis].push_back(bounds.center()[axis]);
        radii.push_back(bounds.radius());
    }
    if (radii.empty()) return glm::dvec3(0.0);
    const vec3 center(median(centers[0]), median(centers[1]), median(centers[2]));
    std::vector<float> distances;
    for (std::size_t i = 0; i < radii.size(); ++i)
        distances.push_back(glm::distance(vec3(centers[0][i], centers[1][i], centers[2][i]), center));
    const float size = std::max(median(radii), median(distances));
    constexpr float near = 8.0f; // sizes: within, a float's step is a millionth of the size at most
    if (!(glm::length(center) > near * size)) return glm::dvec3(0.0);
    // Multiples of the size, or of what keeps 22 of a float's 24 bits where that is more.
    const double farthest = std::max({std::abs(center.x), std::abs(center.y), std::abs(center.z)});
    const double step = std::exp2(std::ceil(std::log2(std::max(double{size}, farthest * 0x1p-22))));
    return glm::round(glm::dvec3(center) / step) * step;
}

std::size_t triangle_count(const Scene& scene) {
    std::size_t count = 0;
    for (const Instance& instance : scene.instances) count += scene.meshes[instance.mesh].indices.size() / 3;
    return count;
}

bool is_unlit(const Mesh& mesh, const Material& material) {
    return material.is_unlit || (!mesh.is_surface() && mesh.normals.empty());
}

bool is_closed(const Mesh& mesh) {
    std::map<std::array<float, 3>, int> places;
    std::vector<int> place_of; // of each vertex
    for (const vec3 p : mesh.positions)
        place_of.push_back(
            places.try_emplace({p.x, p.y, p.z}, static_cast<int>(places.size())).first->second);
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
