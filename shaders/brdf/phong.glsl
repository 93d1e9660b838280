// Phong's lobe around the mirrored direction, made reciprocal and normalised.
//
//   f_r = ρ_s (e + 2)/2π max(m·wi, 0)^e,    m = 2 (n·wo) n - wo,    p(wi) = (e + 1)/2π max(m·wi, 0)^e          [1/sr]
//
// Phong 1975; Lafortune & Willems 1994, "Using the modified Phong reflectance model for physically based rendering",
// Eq. 7 (f_r) and 10 (p). ρ_s: what comes back at normal incidence; less elsewhere, since the lobe reaches below the horizon.
#include "base/constants.glsl"
#include "base/frame_around.glsl"

float phong_power(vec3 n, vec3 wi, vec3 wo, float exponent) {
    return pow(max(dot(reflect(-wo, n), wi), 0.0), exponent);
}

float f_phong(vec3 n, vec3 wi, vec3 wo, float exponent) {
    return (exponent + 2.0) / (2.0 * pi) * phong_power(n, wi, wo, exponent);
}

// A direction around `axis` with a density as the power of its cosine.
vec3 sample_power_of_cosine(vec3 axis, float exponent, vec2 u) {
    float c = pow(u.x, 1.0 / (exponent + 1.0));
    float s = sqrt(max(1.0 - c * c, 0.0));
    float phi = 2.0 * pi * u.y;
    return frame_around(axis) * vec3(s * cos(phi), s * sin(phi), c);
}

vec3 sample_phong(vec3 n, vec3 wo, float exponent, vec2 u) {
    return sample_power_of_cosine(reflect(-wo, n), exponent, u);
}

float p_phong(vec3 n, vec3 wi, vec3 wo, float exponent) {
    return (exponent + 1.0) / (2.0 * pi) * phong_power(n, wi, wo, exponent);
}
