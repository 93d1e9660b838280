// GGX microfacets that are rougher along one direction t than across it.
//
//   D(h)  = 1 / (π α_t α_b ((t·h / α_t)² + (b·h / α_b)² + (n·h)²)²)                    [1/sr]
//   V     = 1 / (2 (cos_i |(α_t t·o, α_b b·o, n·o)| + cos_o |(α_t t·i, α_b b·i, n·i)|))
//   p(wi) = D(h) / (2 (cos_o + |(α_t t·o, α_b b·o, n·o)|))                             [1/sr]
//
// D: Burley 2012, Eq. 13 with γ = 2. V: height-correlated Smith, Heitz 2014, Eq. 86 and 99, divided by 4 cos_i cos_o. p: the normals
// that wo sees, Heitz 2018, Eq. 2 and 17, drawn after Dupuy & Benyoub 2023, Listing 3. α_t = α_b is ggx.glsl.
#include "base/constants.glsl"
#include "base/unit.glsl"

// Directions in the frame of a surface: w * frame is local.
mat3 anisotropic_frame(vec3 n, vec3 t) { return mat3(t, cross(n, t), n); }

float D_ggx_anisotropic(vec3 h, vec2 alphas) { // h in the frame
    vec3 q = vec3(h.xy / alphas, h.z);
    float d = dot(q, q);
    return 1.0 / (pi * alphas.x * alphas.y * d * d);
}

float V_smith_ggx_anisotropic(vec3 i, vec3 o, vec2 alphas) {
    return 0.5 / (i.z * length(vec3(alphas * o.xy, o.z)) + o.z * length(vec3(alphas * i.xy, i.z)));
}

vec3 sample_ggx_anisotropic(mat3 frame, vec3 wo, vec2 alphas, vec2 u) {
    vec3 o = wo * frame;
    vec3 o_stretched = normalize(vec3(alphas * o.xy, o.z));
    float phi = 2.0 * pi * u.x;
    float z = (1.0 - u.y) * (1.0 + o_stretched.z) - o_stretched.z;
    float r = sqrt(clamp(1.0 - z * z, 0.0, 1.0));
    vec3 h_stretched = vec3(r * cos(phi), r * sin(phi), z) + o_stretched;
    return reflect(-wo, frame * normalize(vec3(alphas * h_stretched.xy, h_stretched.z)));
}

float p_ggx_anisotropic(mat3 frame, vec3 wi, vec3 wo, vec2 alphas) {
    vec3 o = wo * frame;
    o.z = max(o.z, 0.0);
    return D_ggx_anisotropic(half_vector(wi, wo, frame[2]) * frame, alphas) / (2.0 * (o.z + length(vec3(alphas * o.xy, o.z))));
}
