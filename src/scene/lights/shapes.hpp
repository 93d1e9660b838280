#pragma once
// Shapes that several emitters are made of: their meshes, and random points on them.
#include "scene/lights/emitter.hpp"

#include <algorithm>

namespace sr::scene {

/// Returns two unit vectors that make a frame with n, and n.
mat3 frame_around(vec3 n);

/// Returns a point of the unit disk, uniform over its area.
vec2 in_disk(vec2 u);

/// Returns barycentric weights of the second and third corner, uniform over a triangle (Turk 1990).
vec2 in_triangle(vec2 u);

/// Returns a point of a ball as a map's sample of a sphere has it: of the unit 3-sphere a uniform point, less
/// its last coordinate, which has a density over √(1 - r²) (Shoemake 1992, "Uniform random rotations").
EmitterPoint in_ball(vec3 center, float radius, vec3 u);

/// The random numbers of in_ball() that choose its center: the coordinate that is dropped is all.
inline constexpr vec3 ball_center{1.0f, 0.0f, 0.25f};

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

float triangle_area(vec3 a, vec3 b, vec3 c);

/// Point i of `count` around the unit circle.
vec2 on_circle(int i, int count);

/// The corners of a round mesh around its axis, a multiple of four. A chord of 1/128 of a turn leaves the
/// circle by 1 - cos(π/128) = 0.03 % of the radius.
inline constexpr int corners_around = 128;

/// Tessellates a flat outline as a fan around its first corner.
Mesh fan_mesh(const std::vector<vec3>& corners, vec3 normal);

/// Tessellates all points within `radius` of the axis from center - half_axis to center + half_axis.
Mesh capsule_mesh(vec3 center, vec3 half_axis, float radius, int around = corners_around);

/// Tessellates the polygon center + s*half_u + t*half_v for the corners (s, t), with the texture coordinates
/// of its map.
template<class Flat>
Mesh flat_mesh(const Flat& light, const std::vector<vec2>& st) {
    std::vector<vec3> corners;
    for (const vec2 p : st) corners.push_back(light.center + p.x * light.half_u + p.y * light.half_v);
    Mesh mesh = fan_mesh(corners, light.normal());
    if (light.map.is_present())
        for (const vec2 p : st)
            mesh.texcoords[0].push_back(light.map.origin + p.x * light.map.along_u + p.y * light.map.along_v);
    return mesh;
}

/// Returns the surface of a flat light with a map, as cameras see it; absent if it is invisible.
template<class Flat>
std::optional<LightSurface> flat_surface(const Flat& light, const std::vector<vec2>& st) {
    if (!light.is_visible) return std::nullopt;
    return LightSurface{flat_mesh(light, st), light.L, light.is_two_sided, light.map.texture};
}

/// The point center + s*half_u + t*half_v of a flat light.
template<class Flat>
EmitterPoint point_on_plane(const Flat& light, vec2 st) {
    return {light.center + st.x * light.half_u + st.y * light.half_v, light.normal(), light.area(),
            light.map.origin + st.x * light.map.along_u + st.y * light.map.along_v, light.is_two_sided};
}

/// The totals of a flat light of that area: Φ = ∫ L A cosθ dω over its hemisphere = π A L, I = L A on its
/// normal.
template<class Flat>
Radiator flat_radiator(const Flat& light, double area) {
    return {light.is_two_sided ? 2.0 * area : area, area};
}

/// The box around center ± half.
Bounds box_around(vec3 center, vec3 half);

/// The area of the parallelogram of u and v.
double parallelogram(vec3 u, vec3 v);

inline constexpr double pi64 = 3.14159265358979323846;

} // namespace sr::scene
