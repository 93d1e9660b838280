// A1.4 and A1.5: directions and solid angles. z points up; angles are in radians.
#include "assignment/not_implemented.glsl"
#include "base/constants.glsl"

// begin solution A1.4
// The unit direction at the angle θ from +z, turned by φ from +x towards +y.
vec3 direction(float theta, float phi) {
    return vec3(sin(theta) * cos(phi), sin(theta) * sin(phi), cos(theta));
}

// And back: (θ, φ) of a unit direction, θ from 0 to π. φ may have any whole number of turns in it.
vec2 angles(vec3 w) { return vec2(acos(clamp(w.z, -1.0, 1.0)), atan(w.y, w.x)); }
// end

// begin solution A1.5
// dω = sinθ dθ dφ: the solid angle of a small step in both angles                      [sr]
float d_omega(float theta, float d_theta, float d_phi) { return sin(theta) * d_theta * d_phi; }

// ω = ∫ ∫ sinθ dθ dφ, where θ goes from theta_0 to theta_1 and φ over a range of d_phi  [sr]
float omega_of_patch(float theta_0, float theta_1, float d_phi) {
    return (cos(theta_0) - cos(theta_1)) * d_phi;
}

// The solid angle of a cone: all directions no further than alpha from its axis         [sr]
float omega_of_cone(float alpha) {
    float s = sin(0.5 * alpha);
    return 4.0 * pi * s * s;
}
// end
