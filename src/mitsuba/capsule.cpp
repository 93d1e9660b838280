#include "mitsuba/capsule.hpp"

#include <cmath>

namespace sr::mitsuba {
namespace {

constexpr std::uint32_t around = 192;
constexpr std::uint32_t rings = 48; // of a hemisphere

/// The rings of both hemispheres, from pole to pole, of a capsule whose radius is `radius`.
Triangles tessellated(const scene::TubeLight& light, float radius) {
    const float length = glm::length(light.half_axis);
    const vec3 pole = length > 0.0f ? light.half_axis / length : vec3(0, 1, 0);
    const vec3 u = glm::normalize(glm::cross(std::abs(pole.x) < 0.5f ? vec3(1, 0, 0) : vec3(0, 1, 0), pole));
    const vec3 v = glm::cross(pole, u);
    Triangles capsule;
    for (std::uint32_t ring = 0; ring <= 2 * rings + 1; ++ring) {
        const bool is_near = ring > rings; // the hemisphere at the axis' end
        const float steps = static_cast<float>(is_near ? ring - 1 : ring) - static_cast<float>(rings);
        const float latitude = 0.5f * pi * steps / static_cast<float>(rings);
        for (std::uint32_t i = 0; i < around; ++i) {
            const float turn = 2.0f * pi * static_cast<float>(i) / static_cast<float>(around);
            const vec3 n =
                std::cos(latitude) * (std::cos(turn) * u + std::sin(turn) * v) + std::sin(latitude) * pole;
            capsule.normals.push_back(n);
            capsule.positions.push_back(light.center + (is_near ? 1.0f : -1.0f) * light.half_axis
                                        + radius * n);
        }
    }
    for (std::uint32_t ring = 0; ring <= 2 * rings; ++ring) {
        for (std::uint32_t i = 0; i < around; ++i) {
            const std::uint32_t a = ring * around + i, b = ring * around + (i + 1) % around;
            capsule.indices.insert(capsule.indices.end(), {a, b, b + around, a, b + around, a + around});
        }
    }
    return capsule;
}

double area_of(const Triangles& triangles) {
    double area = 0.0;
    for (std::size_t i = 0; i + 2 < triangles.indices.size(); i += 3) {
        const auto corner = [&](std::size_t k) { return triangles.positions[triangles.indices[i + k]]; };
        area +=
            0.5 * static_cast<double>(glm::length(glm::cross(corner(1) - corner(0), corner(2) - corner(0))));
    }
    return area;
}

} // namespace

Triangles capsule(const scene::TubeLight& light) {
    // The surface is 4π r (r + h): one Newton step from the inscribed capsule, whose surface is too small by
    // 10⁻⁴.
    const double r = light.radius, h = glm::length(light.half_axis), wanted = light.area();
    const double missing = wanted - area_of(tessellated(light, light.radius));
    const double slope = 4.0 * static_cast<double>(pi) * (2.0 * r + h);
    return tessellated(light, static_cast<float>(r + missing / slope));
}

} // namespace sr::mitsuba
