// Blinn's lobe around the half vector, normalised.
//
//   f_r = ρ_s (e + 2)(e + 4) / (8π (2^(-e/2) + e)) (n·h)^e,    p(wi) = (e + 1)/2π (n·h)^e / (4 wo·h)          [1/sr]
//
// Blinn 1977. The factor makes ρ_s the albedo at normal incidence, the largest there is (Giesen 2009, "Phong and
// Blinn-Phong normalization factors"). p: h drawn as the power of its cosine, then dω_h/dω_i (Walter et al. 2007, Eq. 14).
#include "base/unit.glsl"
#include "brdf/phong.glsl"

float blinn_power(vec3 n, vec3 wi, vec3 wo, float exponent) {
    return power_of_cosine(n, half_vector(wi, wo, n), exponent);
}

float f_blinn_phong(vec3 n, vec3 wi, vec3 wo, float exponent) {
    float e = exponent;
    return (e + 2.0) * (e + 4.0) / (8.0 * pi * (exp2(-0.5 * e) + e)) * blinn_power(n, wi, wo, e);
}

// wi is below the horizon, where f_r is zero, or behind h, where the density is that of -h, and not of h.
vec3 sample_blinn_phong(vec3 n, vec3 wo, float exponent, vec2 u) {
    return reflect(-wo, sample_power_of_cosine(n, exponent, u));
}

float p_blinn_phong(vec3 n, vec3 wi, vec3 wo, float exponent) {
    vec3 h = half_vector(wi, wo, n);
    float cos_h = dot(wo, h);
    return cos_h > 0.0 ? (exponent + 1.0) / (2.0 * pi) * power_of_cosine(n, h, exponent) / (4.0 * cos_h) : 0.0;
}
