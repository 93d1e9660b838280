#pragma once
// Shadow casters: every triangle of a scene, in world space.
#include "shadow/transparency.hpp"

#include <array>
#include <span>

namespace sr::shadow {

/// Data shared by the triangles of one instance.
struct Caster {
    /// The lights that this surface is. A ray that was sent to one of them does not end at its own emitter:
    /// it ignores hits within the last `own_share` of its length.
    scene::LightRange emits_as;
    float own_share = 0.0f;
    scene::AlphaMode alpha_mode = scene::AlphaMode::opaque;
    float alpha_cutoff = 0.5f;
    /// Of a single-sided surface: 1 where the triangles' front is the side of cross(1 - 0, 2 - 0), -1 where
    /// an instance that mirrors makes it the other. 0: double-sided, or there is no light to which that
    /// matters.
    float front = 0.0f;
    int alpha_map = -1; // index into Casters::alpha_maps; negative: none
    int first_triangle = 0;
    int first_corner = -1; // of its first triangle in Casters::alpha_corners, of glass in glass_corners;
                           // negative: it is opaque throughout
    int glass = -1;        // index into Casters::glass; negative: it is none

    /// Blocks everything that meets it.
    bool is_plain() const { return emits_as.is_empty() && first_corner < 0 && front == 0.0f; }
};

/// An emitter whose own surface cannot come between itself and the outside (flat or convex, and alone on its
/// instance) is ignored altogether. Of a mesh's or a group's own surface only the last thousandth of a ray
/// is: more than the rounding of the ray's end, less than shows.
inline constexpr float whole_ray = 1.0f;
inline constexpr float last_thousandth = 1e-3f;

/// Triangles keep their order: instance by instance as in the scene, none left out, so that triangle t of an
/// instance is caster.first_triangle + t. Both sides block, but for lights that pass back faces
/// (scene::passes_back_faces).
struct Casters {
    std::vector<vec3> corners;              // three a triangle [m]
    std::vector<std::uint32_t> caster_of;   // of each triangle
    std::vector<Caster> casters;            // one an instance
    std::vector<AlphaCorner> alpha_corners; // three a triangle of those that are not opaque
    std::vector<Glass> glass;               // one an instance that is of it
    std::vector<GlassCorner> glass_corners; // three a triangle of those
    std::vector<AlphaMap> alpha_maps;
    std::vector<std::uint16_t> alpha_texels; // 65535: opaque
    std::vector<bool> passes_back_faces;     // of each light

    std::size_t triangle_count() const { return caster_of.size(); }
    std::span<const vec3, 3> triangle(std::size_t index) const {
        return std::span<const vec3, 3>(&corners[3 * index], 3);
    }
    /// Returns whether V has a colour.
    bool is_tinted() const { return !glass.empty(); }
};

/// Collects the triangles that cast shadows.
/// @throws Error if there are more than a float can count (2^24)
Casters collect_casters(const scene::Scene& scene, std::span<const scene::Light> lights);

/// Returns whether the light does not see the triangle that a ray towards it meets: it passes back faces, and
/// the ray arrives at the front of a single-sided triangle, which is where the light would come out.
bool is_passed_from_behind(const Casters& casters, std::uint32_t triangle, int light, vec3 ray_direction);

/// The share of the light that the triangle lets through where a ray of that direction meets it, at corner 0
/// + u (1
/// - 0) + v (2 - 0): 0 or 1, or anything between for alphaMode BLEND and for glass.
vec3 transmittance(const Casters& casters, std::uint32_t triangle, float u, float v, vec3 direction);

} // namespace sr::shadow
