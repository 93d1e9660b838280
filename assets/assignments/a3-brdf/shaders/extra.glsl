// A3.6 and A3.7, which are extra. Directions are unit and leave the surface, in axes along t, along b and along the normal:
// w = (w·t, w·b, w·n).
#include "assignment/not_implemented.glsl"
#include "base/constants.glsl"

// begin solution A3.6
// D(h) = 1 / (π α_t α_b (h_t²/α_t² + h_b²/α_b² + h_n²)²)                               [1/sr]
float D_stretched(vec3 h, float alpha_t, float alpha_b) {
    vec3 v = vec3(h.x / alpha_t, h.y / alpha_b, h.z);
    float d = dot(v, v);
    return 1.0 / (pi * alpha_t * alpha_b * d * d);
}

// V = 1 / (2 (wi_n s(wo) + wo_n s(wi))), s(w) = √(α_t² w_t² + α_b² w_b² + w_n²)
float V_stretched(vec3 wi, vec3 wo, float alpha_t, float alpha_b) {
    vec3 alphas = vec3(alpha_t, alpha_b, 1.0);
    return 0.5 / (wi.z * length(alphas * wo) + wo.z * length(alphas * wi));
}
// end

// begin solution A3.7
// (θ_h, θ_d, φ_d): the half angle of two directions, and wi in axes whose pole is h            [rad]
//
// θ_h is the angle between h and n. Turn wi around n by -φ_h, then around b by -θ_h, so that h would come to lie on n:
// θ_d and φ_d are the angles of what you get. φ_d may have any whole number of turns in it.
vec3 half_and_difference(vec3 wi, vec3 wo) {
    vec3 h = normalize(wi + wo);
    vec3 b = length(h.xy) > 0.0 ? vec3(-h.y, h.x, 0.0) / length(h.xy) : vec3(0.0, 1.0, 0.0);
    vec3 t = cross(b, h);
    return vec3(acos(clamp(h.z, -1.0, 1.0)), acos(clamp(dot(wi, h), -1.0, 1.0)), atan(dot(wi, b), dot(wi, t)));
}

// Where these angles are in a table of 90 x 90 x 180 values: (90 √(θ_h / (π/2)), 90 θ_d / (π/2), 180 φ_d / π).
// φ_d and φ_d + π have the same value, so whole π are taken off until φ_d is from 0 to π.
vec3 place_in_table(vec3 angles) {
    return vec3(90.0 * sqrt(2.0 * angles.x / pi), 180.0 * angles.y / pi, 180.0 * fract(angles.z / pi));
}
// end
