// A3.2 to A3.5: GGX microfacets. Directions are unit and leave the surface; n is unit; alpha is the GGX width, α.
#include "base/constants.glsl"
#include "assignment/not_implemented.glsl"

// begin solution A3.2
// D(h) = α² / (π ((n·h)² (α² - 1) + 1)²)                                              [1/sr]
//
// cos_h = n·h.
float D(float cos_h, float alpha) {
    float a2 = alpha * alpha;
    float d = cos_h * cos_h * (a2 - 1.0) + 1.0;
    return a2 / (pi * d * d);
}
// end

// begin solution A3.3
// V = G / (4 cosθ_i cosθ_o) = 1 / (2 (cosθ_i √(cosθ_o² (1 - α²) + α²) + cosθ_o √(cosθ_i² (1 - α²) + α²)))
float V(float cos_i, float cos_o, float alpha) {
    float a2 = alpha * alpha;
    float o = cos_i * sqrt(cos_o * cos_o * (1.0 - a2) + a2);
    float i = cos_o * sqrt(cos_i * cos_i * (1.0 - a2) + a2);
    return 0.5 / (o + i);
}
// end

// begin solution A3.4
// F = F0 + (1 - F0) (1 - cosθ_d)⁵                                                     [1]
//
// cos_d = wi·h.
vec3 F(float cos_d, vec3 F0) {
    float c = 1.0 - cos_d;
    return F0 + (1.0 - F0) * c * c * c * c * c;
}
// end

// begin solution A3.5
// f_r(wi, wo) = D(h) V F with h halfway between wi and wo                              [1/sr]
//
// Call D, V and F. Never the cosine of the equation, never the light.
vec3 f_ggx(vec3 n, vec3 wi, vec3 wo, vec3 F0, float alpha) {
    vec3 h = normalize(wi + wo);
    return D(dot(n, h), alpha) * V(dot(n, wi), dot(n, wo), alpha) * F(dot(wi, h), F0);
}
// end
