// A measured isotropic BRDF (MERL), by half and difference angles.
//
//   f_r = T(θ_h, θ_d, φ_d),    cells of θ_h = (π/2)(i/90)², θ_d = (π/2) j/90, φ_d = π k/180
//
// Matusik et al. 2003; the angles: Rusinkiewicz 1998, section 3. Values are those at the middle of their cells, and linear between. The
// database's own reader takes the nearest cell. φ_d has period π, since f_r is reciprocal; at n = h only θ_d counts.
#include "base/angle.glsl"
#include "base/constants.glsl"
#include "base/frame_around.glsl"
#include "base/unit.glsl"

uniform sampler3D measured_brdf; // 180 φ_d × 90 θ_d × 90 θ_h

// (φ_d, θ_d, θ_h) in cells.
vec3 merl_place(vec3 n, vec3 wi, vec3 wo) {
    vec3 h = half_vector(wi, wo, n);
    vec3 across = cross(n, h); // what h turns around when it is brought to n
    float sin_h = length(across);
    float theta_h = angle_of(vec2(dot(n, h), sin_h));
    // In the frame where h is z and n lies in the plane of x.
    vec3 y = sin_h > 1e-6 ? across / sin_h : frame_around(h)[1];
    vec3 x = cross(y, h);
    float theta_d = angle_of(vec2(dot(h, wi), length(cross(h, wi))));
    float phi_d = angle_of(vec2(dot(x, wi), dot(y, wi)));
    if (phi_d < 0.0) phi_d += pi;
    return vec3(phi_d / pi * 180.0, theta_d / (0.5 * pi) * 90.0, sqrt(clamp(theta_h / (0.5 * pi), 0.0, 1.0)) * 90.0);
}

vec3 merl_cell(ivec3 cell) {
    return texelFetch(measured_brdf, ivec3((cell.x + 180) % 180, clamp(cell.yz, ivec2(0), ivec2(89))), 0).rgb;
}

vec3 merl_row(ivec3 cell, float f) { return mix(merl_cell(cell), merl_cell(cell + ivec3(1, 0, 0)), f); }

vec3 f_merl(vec3 n, vec3 wi, vec3 wo) {
    vec3 at = merl_place(n, wi, wo) - 0.5;
    ivec3 cell = ivec3(floor(at));
    vec3 f = at - vec3(cell);
    vec3 near = mix(merl_row(cell, f.x), merl_row(cell + ivec3(0, 1, 0), f.x), f.y);
    vec3 far = mix(merl_row(cell + ivec3(0, 0, 1), f.x), merl_row(cell + ivec3(0, 1, 1), f.x), f.y);
    return mix(near, far, f.z);
}
