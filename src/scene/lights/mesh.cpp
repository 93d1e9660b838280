#include "scene/lights/mesh.hpp"

#include "scene/lights/emitter.hpp"

namespace sr::scene {

float MeshLight::area() const {
    float doubled = 0.0f;
    for (const auto& [corners, uv] : triangles)
        doubled += glm::length(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
    return 0.5f * doubled;
}

vec3 MeshLight::center() const {
    vec3 sum(0.0f);
    for (const Triangle& triangle : triangles)
        for (const vec3 corner : triangle.corners) sum += corner;
    return sum / static_cast<float>(3 * triangles.size());
}

Radiator MeshLight::radiator() const {
    double sum = 0.0;
    for (const auto& [corners, uv] : triangles)
        sum += 0.5 * parallelogram(corners[1] - corners[0], corners[2] - corners[0]);
    return {is_two_sided ? 2.0 * sum : sum, std::nullopt};
}

Bounds MeshLight::bounds() const {
    Bounds box;
    for (const Triangle& triangle : triangles)
        for (const vec3 corner : triangle.corners) box.extend(corner);
    return box;
}

void MeshLight::transform(const Motion& by) {
    for (Triangle& triangle : triangles)
        for (vec3& corner : triangle.corners) corner = by.place(corner);
}

EmitterPoint MeshLight::sample_point(vec3 u) const {
    if (triangles.empty()) return {};
    vec2 place(u);
    const float whole = area();
    const std::size_t i = part_at(place.x, triangles.size(), whole, [&](std::size_t part) {
        const auto& c = triangles[part].corners;
        return triangle_area(c[0], c[1], c[2]);
    });
    const auto& [c, uv] = triangles[i];
    const vec2 weights = in_triangle(place);
    return {c[0] + weights.x * (c[1] - c[0]) + weights.y * (c[2] - c[0]),
            glm::normalize(glm::cross(c[1] - c[0], c[2] - c[0])), whole,
            uv[0] + weights.x * (uv[1] - uv[0]) + weights.y * (uv[2] - uv[0]), is_two_sided};
}

} // namespace sr::scene
