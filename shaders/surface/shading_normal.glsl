// n: the normal that the BRDF sees.
#include "surface/textures.glsl"

// Tangent space as MikkTSpace defines it (Mikkelsen 2008): the interpolated vectors are used at the length they
// have, and the sum is normalised once.
vec3 mapped_normal() {
    if (!has_normal_texture) return normalize(vertex_normal);
    vec3 m = texture(normal_texture, uv(normal_slot)).xyz * 2.0 - 1.0;
    m.xy *= normal_scale;
    vec3 bitangent = vertex_tangent.w * cross(vertex_normal, vertex_tangent.xyz);
    return normalize(m.x * vertex_tangent.xyz + m.y * bitangent + m.z * vertex_normal);
}

// Where interpolation or a normal map turns n away from the viewer, it is bent back until wo grazes the surface:
// f_r stays finite and continuous there, and no black fringe appears along silhouettes.
vec3 facing(vec3 n, vec3 wo) {
    float cos_o = dot(n, wo);
    return cos_o >= 0.0 ? n : normalize(n - cos_o * wo);
}

vec3 shading_normal(vec3 wo) {
    vec3 n = mapped_normal();
    return facing(gl_FrontFacing ? n : -n, wo);
}
