// A3.1: Phong's lobe as a BRDF. Directions are unit and leave the surface; n is unit.
#include "base/constants.glsl"
#include "assignment/not_implemented.glsl"

// begin solution A3.1
// f_r(wi, wo) = k (m + 2) / (2π) max(0, cos γ)^m                                       [1/sr]
//
// γ is the angle between wo and the mirror image of wi: r = 2 (n·wi) n - wi. m is the exponent.
float f_phong(vec3 n, vec3 wi, vec3 wo, float k, float m) {
    vec3 r = 2.0 * dot(n, wi) * n - wi;
    return k * (m + 2.0) / (2.0 * pi) * pow(max(0.0, dot(r, wo)), m);
}
// end
