// GGX microfacets: the distribution of normals and the shadowing between them.
//
//   D(h) = α² / (π ((n·h)² (α² - 1) + 1)²)                                            [1/sr]
//   V    = G / (4 cos_i cos_o)
//        = 1 / (2 (cos_i √(cos_o² (1 - α²) + α²) + cos_o √(cos_i² (1 - α²) + α²)))
//
// D: Walter et al. 2007, Eq. 33. V: height-correlated Smith, Heitz 2014, Eq. 99, divided through by 4 cos_i cos_o,
// so that no epsilon is needed. Limits: α > 0, cos_i > 0, cos_o >= 0.
#include "base/constants.glsl"

// With (n·h)² (α² - 1) + 1 = |n×h|² + α² (n·h)², which does not cancel where n·h is close to 1.
float D_ggx(vec3 n, vec3 h, float alpha) {
    vec3 s = cross(n, h);
    float c = dot(n, h);
    float a2 = alpha * alpha;
    float d = dot(s, s) + a2 * c * c;
    return a2 / (pi * d * d);
}

float V_smith_ggx(float cos_i, float cos_o, float alpha) {
    float a2 = alpha * alpha;
    float lambda_o = cos_i * sqrt(cos_o * cos_o * (1.0 - a2) + a2);
    float lambda_i = cos_o * sqrt(cos_i * cos_i * (1.0 - a2) + a2);
    return 0.5 / (lambda_o + lambda_i);
}
