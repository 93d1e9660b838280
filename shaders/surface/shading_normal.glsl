// n: the normal that the BRDF sees.
#include "base/frame_around.glsl"
#include "base/unit.glsl"
#include "surface/textures.glsl"

// The triangle's own normal, on its front; lines and points have none, 0.
vec3 triangle_normal() {
    if (is_line || is_point) return vec3(0.0);
    return unit_or(is_front() ? across_triangle() : -across_triangle(), vec3(0.0, 1.0, 0.0));
}

// Where the corners' normals cancel out, the triangle has its own.
vec3 interpolated_normal() { return unit_or(vertex_normal, triangle_normal()); }

// From tangent space as MikkTSpace defines it (Mikkelsen 2008): the interpolated vectors are used at the length they
// have, and the sum is normalised once. Their length is 1 at the vertices in world space. The bitangent is the cross
// product of the transformed vectors, not the transformed bitangent: glTF 2.0, section 3.7.2.1, defines it by the
// normal and the tangent, so a node that is not scaled evenly leaves the map's angles as they are.
vec3 from_tangent_space(vec3 m) {
    vec3 bitangent = vertex_tangent.w * cross(vertex_normal, vertex_tangent.xyz);
    return unit_or(m.x * vertex_tangent.xyz + m.y * bitangent + m.z * vertex_normal, interpolated_normal());
}

vec3 mapped_normal() {
    if (!has_normal_texture) return interpolated_normal();
    vec3 m = texel(normal_texture, normal_slot).xyz * 2.0 - 1.0;
    return from_tangent_space(vec3(m.xy * normal_scale, m.z));
}

// The coat follows its own map, not that of what it covers (KHR_materials_clearcoat).
vec3 mapped_clearcoat_normal() {
    if (!has_clearcoat_normal_texture) return interpolated_normal();
    vec3 m = texel(clearcoat_normal_texture, clearcoat_normal_slot).xyz * 2.0 - 1.0;
    return from_tangent_space(vec3(m.xy * clearcoat_factor.z, m.z));
}

// Where interpolation or a normal map turns n away from the viewer, it is bent back until wo grazes the surface:
// f_r stays finite and continuous there, and no black fringe appears along silhouettes.
vec3 facing(vec3 n, vec3 wo) {
    float cos_o = dot(n, wo);
    return cos_o >= 0.0 ? n : unit_or(n - cos_o * wo, frame_around(wo)[0]);
}

// Lines and points have no back: n is taken for the side that is seen, and faces the viewer where there is none.
vec3 on_seen_side(vec3 n, vec3 wo) {
    if (is_line || is_point) return unit_or(dot(n, wo) < 0.0 ? -n : n, wo);
    return facing(is_front() ? n : -n, wo);
}

vec3 shading_normal(vec3 wo) { return on_seen_side(mapped_normal(), wo); }
