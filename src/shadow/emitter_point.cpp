#include "shadow/emitter_point.hpp"

#include <algorithm>
#include <cmath>

namespace sr::shadow {
namespace {

/// Two unit vectors that make a frame with n.
mat3 frame_around(vec3 n) {
    const vec3 slanted = std::abs(n.x) < 0.5f ? vec3(1, 0, 0) : vec3(0, 1, 0);
    const vec3 u = glm::normalize(glm::cross(slanted, n));
    return {u, glm::cross(n, u), n};
}

/// Of the unit 3-sphere a uniform point, less its last coordinate: within the unit ball with a density over
/// √(1 - r²) (Shoemake 1992, "Uniform random rotations").
vec3 in_ball_like_disk(vec3 u) {
    const float a = std::sqrt(1.0f - u.x), b = std::sqrt(u.x);
    const float first = 2.0f * pi * u.y, second = 2.0f * pi * u.z;
    return {a * std::cos(first), a * std::sin(first), b * std::cos(second)};
}

/// Uniform over the unit disk.
vec2 in_disk(vec2 u) { return std::sqrt(u.x) * vec2(std::cos(2.0f * pi * u.y), std::sin(2.0f * pi * u.y)); }

/// Uniform over the unit sphere, (0, 0) its uppermost point.
vec3 on_sphere(vec2 u) {
    const float across = 2.0f * std::sqrt(u.y * (1.0f - u.y));
    return {across * std::cos(2.0f * pi * u.x), 1.0f - 2.0f * u.y, across * std::sin(2.0f * pi * u.x)};
}

/// Barycentric weights of the second and third corner, uniform over a triangle (Turk 1990).
vec2 in_triangle(vec2 u) {
    const float root = std::sqrt(u.x);
    return {root * (1.0f - u.y), root * u.y};
}

template<class Flat>
EmitterPoint on_plane(const Flat& light, vec2 st) {
    return {light.center + st.x * light.half_u + st.y * light.half_v, light.normal(), light.area(),
            light.map.origin + st.x * light.map.along_u + st.y * light.map.along_v, light.is_two_sided};
}

/// Chooses one of several parts by size; u becomes its place within that part.
template<class SizeOf>
std::size_t part_at(float& u, std::size_t count, float total, const SizeOf& size_of) {
    float rest = u * total;
    for (std::size_t i = 0; i + 1 < count; ++i) {
        const float size = size_of(i);
        if (rest < size) {
            u = rest / size;
            return i;
        }
        rest -= size;
    }
    u = std::clamp(rest / size_of(count - 1), 0.0f, 1.0f);
    return count - 1;
}

float area_of(vec3 a, vec3 b, vec3 c) { return 0.5f * glm::length(glm::cross(b - a, c - a)); }

struct PointOn {
    vec3 u;

    EmitterPoint operator()(const scene::PointLight& light) const {
        return round(light.position, light.radius);
    }
    EmitterPoint operator()(const scene::SpotLight& light) const {
        return round(light.position, light.radius);
    }
    EmitterPoint operator()(const scene::SphereLight& light) const {
        return round(light.center, light.radius);
    }

    EmitterPoint operator()(const scene::DirectionalLight& light) const {
        const float half_sine = std::sin(0.5f * light.angular_radius);
        const float height = 2.0f * half_sine * half_sine * u.y; // 1 - cosθ
        const float across = std::sqrt(height * (2.0f - height));
        const vec3 local(across * std::cos(2.0f * pi * u.x), across * std::sin(2.0f * pi * u.x),
                         1.0f - height);
        EmitterPoint point{glm::normalize(frame_around(-light.direction) * local)};
        point.is_far = true;
        return point;
    }

    EmitterPoint operator()(const scene::RectangleLight& light) const {
        return on_plane(light, 2.0f * vec2(u) - 1.0f);
    }
    EmitterPoint operator()(const scene::DiskLight& light) const { return on_plane(light, in_disk(vec2(u))); }

    /// Uniform over the volume: in the cylinder, or in one of the halves of the ball that the ends make.
    EmitterPoint operator()(const scene::TubeLight& light) const {
        const float half_length = glm::length(light.half_axis);
        const vec3 axis = half_length > 0.0f ? light.half_axis / half_length : vec3(0, 1, 0);
        const float in_cylinder = half_length / (half_length + 2.0f / 3.0f * light.radius);
        const mat3 frame = frame_around(axis);
        vec3 local;
        if (u.z < in_cylinder) {
            local = vec3(light.radius * in_disk(vec2(u)), (2.0f * u.z / in_cylinder - 1.0f) * half_length);
        } else {
            const float z = 2.0f * u.x - 1.0f, across = std::sqrt(1.0f - z * z);
            const float r =
                light.radius * std::cbrt(std::min((u.z - in_cylinder) / (1.0f - in_cylinder), 1.0f));
            local = r * vec3(across * std::cos(2.0f * pi * u.y), across * std::sin(2.0f * pi * u.y), z);
            local.z += z < 0.0f ? -half_length : half_length;
        }
        return {light.center + frame * local};
    }

    EmitterPoint operator()(const scene::PolygonLight& light) const {
        const auto& c = light.corners;
        vec2 place(u);
        const float area = light.area();
        const std::size_t i = part_at(place.x, c.size() - 2, area, [&](std::size_t part) {
            return area_of(c[0], c[part + 1], c[part + 2]);
        });
        const vec2 weights = in_triangle(place);
        return {c[0] + weights.x * (c[i + 1] - c[0]) + weights.y * (c[i + 2] - c[0]), light.normal(), area,
                vec2(0.0f), light.is_two_sided};
    }

    EmitterPoint operator()(const scene::MeshLight& light) const {
        if (light.triangles.empty()) return {};
        vec2 place(u);
        const float area = light.area();
        const std::size_t i = part_at(place.x, light.triangles.size(), area, [&](std::size_t part) {
            const auto& c = light.triangles[part].corners;
            return area_of(c[0], c[1], c[2]);
        });
        const auto& [c, uv] = light.triangles[i];
        const vec2 weights = in_triangle(place);
        return {c[0] + weights.x * (c[1] - c[0]) + weights.y * (c[2] - c[0]),
                glm::normalize(glm::cross(c[1] - c[0], c[2] - c[0])), area,
                uv[0] + weights.x * (uv[1] - uv[0]) + weights.y * (uv[2] - uv[0]), light.is_two_sided};
    }

    /// A direction, with the density of environment.glsl.
    EmitterPoint operator()(const scene::EnvironmentLight& light) const {
        EmitterPoint point;
        point.is_far = true;
        point.place = glm::normalize(light.map && light.map->has_light()
                                         ? light.map->sample(vec2(u)) * light.map_from_world()
                                         : on_sphere(vec2(u)));
        return point;
    }

    EmitterPoint round(vec3 center, float radius) const { return {center + radius * in_ball_like_disk(u)}; }
};

struct HasExtent {
    bool operator()(const scene::PointLight& light) const { return light.radius > 0.0f; }
    bool operator()(const scene::SpotLight& light) const { return light.radius > 0.0f; }
    bool operator()(const scene::DirectionalLight& light) const { return light.angular_radius > 0.0f; }
    bool operator()(const auto&) const { return true; }
};

/// The random numbers that choose the middle.
struct MiddleOf {
    vec3 operator()(const scene::TubeLight& light) const { // half of the cylinder's share
        const float half_length = glm::length(light.half_axis);
        return {0.0f, 0.0f, 0.5f * half_length / (half_length + 2.0f / 3.0f * light.radius)};
    }
    vec3 operator()(const scene::DirectionalLight&) const { return vec3(0.0f); }
    vec3 operator()(const scene::DiskLight&) const { return vec3(0.0f); }
    vec3 operator()(const scene::EnvironmentLight&) const { return vec3(0.0f); }
    vec3 operator()(const scene::RectangleLight&) const { return vec3(0.5f); }
    vec3 operator()(const scene::PolygonLight&) const { return vec3(0.5f); }
    vec3 operator()(const scene::MeshLight&) const { return vec3(0.5f); }
    vec3 operator()(const auto&) const {
        return {1.0f, 0.0f, 0.25f};
    } // the coordinate that is dropped is all
};

} // namespace

EmitterPoint middle_of(const scene::Light& light) {
    if (std::holds_alternative<scene::EnvironmentLight>(light)) { // it has none: what comes from above
        EmitterPoint point;
        point.is_far = true;
        point.place = vec3(0.0f, 1.0f, 0.0f);
        return point;
    }
    return point_on(light, std::visit(MiddleOf{}, light));
}

bool has_extent(const scene::Light& light) { return std::visit(HasExtent{}, light); }

EmitterPoint point_on(const scene::Light& light, vec3 u) { return std::visit(PointOn{u}, light); }

} // namespace sr::shadow
