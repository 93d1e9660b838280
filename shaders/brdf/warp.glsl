// Linearly transformed cosines: a map M of directions that makes the density cosθ/π into a lobe (Heitz et al. 2016,
// Eq. 1). What a polygon gets of the lobe is what the polygon M⁻¹ gets of the cosine: its irradiance over π.
//
// M = [a 0 b; 0 c 0; 0 0 1] in the frame where n = z and wo lies in y = 0. It leaves the horizon in place, so that
// clipping stays exact and lobe and density vanish together. a, b, c are fitted to GGX (tools/ltc/).
#include "base/constants.glsl"
#include "brdf/albedo_table.glsl"
#include "surface/surface.glsl"

struct Warp {
    mat3 warped_from_world; // M⁻¹, after the turn into the frame
    mat3 world_from_warped;
    float determinant;      // of M
};

mat3 frame_towards(vec3 n, vec3 wo) {
    vec3 across = wo - dot(n, wo) * n;
    float l = length(across);
    vec3 x = l > 1e-4 ? across / l : normalize(abs(n.x) > abs(n.z) ? vec3(-n.y, n.x, 0.0) : vec3(0.0, -n.z, n.y));
    return mat3(x, cross(n, x), n);
}

// Lambert's lobe: nothing to warp.
Warp diffuse_warp(Surface x, vec3 wo) {
    mat3 frame = frame_towards(x.n, wo);
    return Warp(transpose(frame), frame, 1.0);
}

// The GGX lobe's. The table holds the numbers over what they are for α → 0 and at grazing: tools/ltc/fit.cpp.
Warp specular_warp(Surface x, vec3 wo) {
    float cos_o = clamp(dot(x.n, wo), 0.0, 1.0);
    vec3 scaled = textureLod(ltc_table, ltc_place(cos_o, x.alpha, 0.0), 0.0).xyz;
    float softened = cos_o * cos_o + x.alpha * x.alpha;
    float a = scaled.x * 2.0 * x.alpha / softened;
    float b = scaled.y * sqrt((1.0 - cos_o * cos_o) / softened);
    float c = scaled.z * 2.0 * x.alpha;
    mat3 frame = frame_towards(x.n, wo);
    mat3 M = mat3(a, 0.0, 0.0, 0.0, c, 0.0, b, 0.0, 1.0);
    mat3 M_inverse = mat3(1.0 / a, 0.0, 0.0, 0.0, 1.0 / c, 0.0, -b / a, 0.0, 1.0);
    return Warp(M_inverse * transpose(frame), frame * M, a * c);
}

// (∫ D V cosθ, ∫ (1 - w·h)⁵ D V cosθ)
vec2 specular_terms(Surface x, vec3 wo) {
    float cos_o = clamp(dot(x.n, wo), 0.0, 1.0);
    return vec2(textureLod(ltc_table, ltc_place(cos_o, x.alpha, 0.0), 0.0).w,
                textureLod(ltc_table, ltc_place(cos_o, x.alpha, 1.0), 0.0).x);
}
