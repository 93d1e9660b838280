// Directions distributed as the GGX normals that wo sees.
//
//   p(wi) = D(h) G1(wo) / (4 cos_o) = D(h) / (2 (cos_o + √(α² + (1 - α²) cos_o²)))      [1/sr]
//
// Density: Heitz 2018, Eq. 2 and 17, with G1 = 2 cos_o / (cos_o + √(…)) divided out. Sampling: Dupuy & Benyoub 2023,
// Listing 3 (spherical caps). Limit: wi may come out below the horizon, where f_r is zero.
#include "base/frame_around.glsl"
#include "base/unit.glsl"
#include "brdf/ggx.glsl"

vec3 sample_ggx(vec3 n, vec3 wo, float alpha, vec2 u) {
    mat3 world_from_local = frame_around(n);
    vec3 o = wo * world_from_local; // the transpose times wo
    vec3 o_stretched = normalize(vec3(alpha * o.xy, o.z));
    float phi = 2.0 * pi * u.x;
    float z = (1.0 - u.y) * (1.0 + o_stretched.z) - o_stretched.z;
    float r = sqrt(clamp(1.0 - z * z, 0.0, 1.0));
    vec3 h_stretched = vec3(r * cos(phi), r * sin(phi), z) + o_stretched;
    vec3 h = normalize(vec3(alpha * h_stretched.xy, h_stretched.z));
    return reflect(-wo, world_from_local * h);
}

float p_ggx(vec3 n, vec3 wi, vec3 wo, float alpha) {
    float cos_o = max(dot(n, wo), 0.0);
    float a2 = alpha * alpha;
    return D_ggx(n, half_vector(wi, wo, n), alpha) / (2.0 * (cos_o + sqrt(a2 + (1.0 - a2) * cos_o * cos_o)));
}
