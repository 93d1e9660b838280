// A6.1 and A6.2: directions as dense as the cosine, and as a BRDF's lobe.
#include "given.glsl"
#include "assignment/not_implemented.glsl"

// begin solution A6.1
// p(wi) = cosθ_i / π above the surface, 0 below                                         [1/sr]
float cosine_density(vec3 n, vec3 wi) { return max(0.0, dot(n, wi)) / pi; }

// A direction of that density, from u in [0, 1)²                                        [1]
vec3 cosine_direction(vec3 n, vec2 u) {
    float r = sqrt(u.x), phi = 2.0 * pi * u.y;
    return frame_around(n) * vec3(r * cos(phi), r * sin(phi), sqrt(1.0 - u.x));
}
// end

// begin solution A6.2
// p(wi) = (m + 1) / (2π) max(0, cos γ)^m                                                [1/sr]
//
// γ is the angle between wi and r, wo mirrored at n: r = 2 (n·wo) n - wo. m is the exponent.
float lobe_density(vec3 n, vec3 wi, vec3 wo, float m) {
    float cos_g = dot(reflect(-wo, n), wi);
    return cos_g > 0.0 ? (m + 1.0) / (2.0 * pi) * pow(cos_g, m) : 0.0;
}

// A direction of that density, from u in [0, 1)². It may lie below the surface.          [1]
vec3 lobe_direction(vec3 n, vec3 wo, float m, vec2 u) {
    float z = pow(1.0 - u.x, 1.0 / (m + 1.0)), phi = 2.0 * pi * u.y;
    float s = sqrt(max(0.0, 1.0 - z * z));
    return frame_around(reflect(-wo, n)) * vec3(s * cos(phi), s * sin(phi), z);
}
// end
