#pragma once
// The vocabulary that all emitters share: their sizes, totals, points and surfaces.
//
// An emitter is a struct with plain members, in world space, each in its own unit. Colours are folded into
// its quantity: I, E and L are RGB. A photometric scene (glTF) counts in cd, lx and cd/m²; a radiometric one
// in W/sr, W/m² and W/(m² sr). The members of one name mean the same in all emitters:
//   position, center     where it is [m]
//   half_u, half_v       half edges or semi-axes [m], perpendicular
//   half_axis            from the center to an end [m]
//   radius               [m]
//   is_two_sided         it emits on both sides
//   is_visible           false: it lights the scene but cameras do not see it
//   map                  the texture that multiplies L
// A static member `kind` names the emitter in files, in messages and in GLSL (`kind`_light).
#include "scene/ies.hpp"
#include "scene/mesh.hpp"
#include "scene/units.hpp"

#include <algorithm>
#include <optional>
#include <span>
#include <string_view>

namespace sr::scene {

/// A size of the emitter L, by its key in extras.steradian. The member is a number, or one or two axes that
/// grow with the size.
template<class L>
struct Dimension {
    std::string_view key;
    std::string_view unit; // "m" or "rad"
    float per_member;      // the size over the number, or over the axis' length
    float L::*number;      // null: the size is that of `axis`
    vec3 L::*axis = nullptr;
    vec3 L::*other_axis = nullptr; // null: one axis is all

    float of(const L& light) const {
        return per_member * (number ? light.*number : glm::length(light.*axis));
    }
    void scale(L& light, float by) const {
        if (number) light.*number *= by;
        if (axis) light.*axis *= by;
        if (other_axis) light.*other_axis *= by;
    }
};

/// A shape that extras.steradian can name, with the sizes that it needs.
template<class L>
struct NamedShape {
    std::string_view name;
    std::span<const Dimension<L>> dimensions;
};

/// The part of a texture that an emitter's plane shows: at center + s*half_u + t*half_v it reads
/// uv = origin + s*along_u + t*along_v. The texel multiplies L.
struct EmissionMap {
    int texture = -1; // index into Scene::textures; negative: none
    vec2 origin{0.5f, 0.5f};
    vec2 along_u{0.5f, 0.0f};
    vec2 along_v{0.0f, -0.5f}; // a picture's first row is its top

    bool is_present() const { return texture >= 0; }
};

/// The totals of a Lambertian emitter.
struct Radiator {
    double flux_area = 0.0; // Φ / (π L) [m²]: the area; twice it where both sides emit
    /// I / L on the axis [m²]: the area as seen along the emitter's axis; absent where it has none (a mesh).
    std::optional<double> axis_area;
};

/// Returns L of a radiator for a flux (Φ / (π flux_area)), an intensity on the axis (I / axis_area) or a
/// radiance. Absent: this quantity does not determine it (irradiance does not, nor does an intensity without
/// an axis).
std::optional<double> radiance_from(Quantity quantity, double value, const Radiator& radiator);

/// A point on an emitter, uniform over the area of a flat one. Of a sphere or tube it is a point within, as
/// shaders/light/map_sample.glsl has it; of a light with a place and no extent it is the place.
struct EmitterPoint {
    vec3 place{0.0f};          // [m]; of parallel light: the unit direction towards it
    vec3 normal{0.0f};         // unit, the side on which it shines; zero where it shines in all directions
    float extent = 0.0f;       // of a flat emitter: one over the point's density [m²]
    vec2 uv{0.0f};             // where the emitter's texture is read
    bool is_two_sided = false; // it shines on the other side as well
    bool is_far = false;       // parallel light: `place` is a direction
};

/// The surface of an emitter, as cameras see it.
struct LightSurface {
    Mesh mesh;
    vec3 L{0.0f}; // radiance [cd/m²]
    bool is_two_sided = false;
    int texture = -1; // index into Scene::textures; negative: none
};

/// A rotation, a translation and a scale, taken apart for what they move.
struct Motion {
    explicit Motion(const mat4& by);

    vec3 place(vec3 p) const { return vec3(matrix * vec4(p, 1.0f)); }

    mat4 matrix;
    mat3 linear;
    float scale;   // the cube root of the volume's
    mat3 rotation; // exact for a uniform scale
};

// Shapes that several emitters are made of: their meshes, and random points on them.

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
