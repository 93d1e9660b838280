// Directions of a round cone of half angle σ, all equally likely.
//
//   p(w) = 1 / (2π (1 - cosσ))          [1/sr]
//
// The cap's area is proportional to its height (Archimedes). Everything is told by 1 - cosσ, which does not cancel for
// narrow cones.
#include "base/constants.glsl"
#include "base/frame_around.glsl"

float one_minus_cos(float sin2) { return sin2 / (1.0 + sqrt(max(1.0 - sin2, 0.0))); }

float p_cone(float one_minus_cos_sigma) { return 1.0 / (2.0 * pi * one_minus_cos_sigma); }

vec3 sample_cone(vec3 axis, float one_minus_cos_sigma, vec2 u) {
    float height = u.y * one_minus_cos_sigma; // 1 - cosθ
    float sin_theta = sqrt(height * (2.0 - height));
    float phi = 2.0 * pi * u.x;
    return normalize(frame_around(axis) * vec3(sin_theta * cos(phi), sin_theta * sin(phi), 1.0 - height));
}
