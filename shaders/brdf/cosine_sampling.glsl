// Directions distributed as the cosine, for surfaces that scatter everywhere.
//
//   p(wi) = cosθ_i / π          [1/sr]
//
// Malley's method: a disk lifted to the hemisphere (Pharr, Jakob & Humphreys 2016, section 13.6.3).
#include "base/constants.glsl"
#include "base/frame_around.glsl"

vec3 sample_cosine(vec3 n, vec2 u) {
    float r = sqrt(u.x);
    float phi = 2.0 * pi * u.y;
    return frame_around(n) * vec3(r * cos(phi), r * sin(phi), sqrt(1.0 - u.x));
}

float p_cosine(vec3 n, vec3 wi) { return max(dot(n, wi), 0.0) / pi; }
