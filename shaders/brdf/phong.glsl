// Phong's lobe around the mirrored direction, made reciprocal and normalised.
//
//   f_r = ρ_s (e + 2)/2π max(m·wi, 0)^e,    m = 2 (n·wo) n - wo,    p(wi) = (e + 1)/2π max(m·wi, 0)^e          [1/sr]
//
// Phong 1975; Lafortune & Willems 1994, "Using the modified Phong reflectance model for physically based rendering",
// Eq. 7 (f_r) and 10 (p). ρ_s: what comes back at normal incidence; less elsewhere, since the lobe reaches below the horizon.
#include "base/constants.glsl"
#include "base/frame_around.glsl"

// (a·b)^e for unit vectors; near a narrow peak by the sine, since there the cosine has lost its digits:
// log cos² = log(1 - s²) = -2 artanh(s² / (2 - s²)).
float power_of_cosine(vec3 a, vec3 b, float exponent) {
    float c = dot(a, b);
    vec3 s = cross(a, b);
    float s2 = dot(s, s);
    float t = s2 / (2.0 - s2);
    float t2 = t * t;
    float log_cos2 = -2.0 * t * (1.0 + t2 * (1.0 / 3.0 + t2 * (1.0 / 5.0 + t2 / 7.0)));
    if (s2 >= 0.25) log_cos2 = 2.0 * log(c);
    return c > 0.0 ? exp(0.5 * exponent * log_cos2) : 0.0;
}

float phong_power(vec3 n, vec3 wi, vec3 wo, float exponent) { return power_of_cosine(reflect(-wo, n), wi, exponent); }

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
