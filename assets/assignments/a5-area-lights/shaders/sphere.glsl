// A5.5: a sphere, sampled over the cone in which it is seen.
#include "lamps.glsl"
#include "assignment/not_implemented.glsl"

// begin solution A5.5
// p(wi) = 1 / (2π (1 - cosθ_max)) within the cone: sinθ_max = R / d                     [1/sr]
//
// The sphere has its center at c and the radius R [m]; x lies outside, at the distance d from c.
float p_cone(vec3 x, vec3 c, float R) {
    float sin_max = R / length(c - x);
    return 1.0 / (2.0 * pi * (1.0 - sqrt(1.0 - sin_max * sin_max)));
}

// A direction of that density, from u in [0, 1)²                                        [1]
vec3 direction_in_cone(vec3 x, vec3 c, float R, vec2 u) {
    float sin_max = R / length(c - x);
    float cos_max = sqrt(1.0 - sin_max * sin_max);
    float z = 1.0 - u.x * (1.0 - cos_max);
    float phi = 2.0 * pi * u.y;
    float s = sqrt(max(0.0, 1.0 - z * z));
    return frame_around(normalize(c - x)) * vec3(s * cos(phi), s * sin(phi), z);
}
// end
