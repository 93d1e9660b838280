#include "scene/lights/emitter.hpp"

#include <cmath>

namespace sr::scene {

std::optional<double> radiance_from(Quantity quantity, double value, const Radiator& radiator) {
    if (quantity == Quantity::flux) return value / (pi64 * radiator.flux_area);
    if (quantity == Quantity::intensity && radiator.axis_area) return value / *radiator.axis_area;
    if (quantity == Quantity::radiance) return value;
    return std::nullopt;
}

Motion::Motion(const mat4& by)
    : matrix(by),
      linear(by),
      scale(std::cbrt(std::abs(glm::determinant(linear)))),
      rotation(linear / scale) {}

mat3 frame_around(vec3 n) {
    const vec3 slanted = std::abs(n.x) < 0.5f ? vec3(1, 0, 0) : vec3(0, 1, 0);
    const vec3 u = glm::normalize(glm::cross(slanted, n));
    return {u, glm::cross(n, u), n};
}

vec2 in_disk(vec2 u) { return std::sqrt(u.x) * vec2(std::cos(2.0f * pi * u.y), std::sin(2.0f * pi * u.y)); }

vec2 in_triangle(vec2 u) {
    const float root = std::sqrt(u.x);
    return {root * (1.0f - u.y), root * u.y};
}

EmitterPoint in_ball(vec3 center, float radius, vec3 u) {
    const float a = std::sqrt(1.0f - u.x), b = std::sqrt(u.x);
    const float first = 2.0f * pi * u.y, second = 2.0f * pi * u.z;
    return {center + radius * vec3(a * std::cos(first), a * std::sin(first), b * std::cos(second))};
}

float triangle_area(vec3 a, vec3 b, vec3 c) { return 0.5f * glm::length(glm::cross(b - a, c - a)); }

vec2 on_circle(int i, int count) {
    const float angle = 2.0f * pi * static_cast<float>(i % count) / static_cast<float>(count);
    return {std::cos(angle), std::sin(angle)};
}

Mesh fan_mesh(const std::vector<vec3>& corners, vec3 normal) {
    Mesh mesh;
    mesh.positions = corners;
    mesh.normals.assign(corners.size(), normal);
    for (std::uint32_t i = 2; i < corners.size(); ++i) mesh.indices.insert(mesh.indices.end(), {0, i - 1, i});
    return mesh;
}

Mesh capsule_mesh(vec3 center, vec3 half_axis, float radius, int around) {
    const float length = glm::length(half_axis);
    const mat3 frame = frame_around(length > 0.0f ? half_axis / length : vec3(0, 1, 0));
    const int quarter = around / 4; // rings of a hemisphere
    Mesh mesh;
    const auto ring = [&](int latitude, vec3 middle) {
        const float angle = 0.5f * pi * static_cast<float>(latitude) / static_cast<float>(quarter);
        for (int i = 0; i < around; ++i) {
            const vec2 c = on_circle(i, around);
            const vec3 n = std::cos(angle) * (c.x * frame[0] + c.y * frame[1]) + std::sin(angle) * frame[2];
            mesh.normals.push_back(n);
            mesh.positions.push_back(middle + radius * n);
        }
    };
    for (int latitude = -quarter; latitude <= 0; ++latitude) ring(latitude, center - half_axis);
    for (int latitude = 0; latitude <= quarter; ++latitude) ring(latitude, center + half_axis);
    const auto rings = static_cast<int>(mesh.positions.size()) / around;
    for (int r = 0; r + 1 < rings; ++r) {
        for (int i = 0; i < around; ++i) {
            const auto at = [&](int row, int column) {
                return static_cast<std::uint32_t>(row * around + column % around);
            };
            mesh.indices.insert(mesh.indices.end(), {at(r, i), at(r, i + 1), at(r + 1, i + 1)});
            mesh.indices.insert(mesh.indices.end(), {at(r, i), at(r + 1, i + 1), at(r + 1, i)});
        }
    }
    return mesh;
}

Bounds box_around(vec3 center, vec3 half) {
    Bounds box;
    box.extend(center - half);
    box.extend(center + half);
    return box;
}

double parallelogram(vec3 u, vec3 v) { return glm::length(glm::cross(glm::dvec3(u), glm::dvec3(v))); }

} // namespace sr::scene
