// A6.3 and A6.4: two ways to choose a direction, and both together.
#include "sampling.glsl"
#include "assignment/not_implemented.glsl"

// begin solution A6.3
// The power heuristic: the weight of a sample of density p where another way would have found it with q     [1]
//
// p is above 0; q may be 0.
float weight(float p, float q) { return p * p / (p * p + q * q); }
// end

// begin solution A6.4
// f_r L_i cosθ_i / p(wi), wi chosen by lamp_direction(axis, u)                          [cd/m²]
//
// f_r is f_lobe, L_i is L_lamp. Below the surface cosθ_i counts as 0.
float L_r_by_lamp(vec3 n, vec3 wo, vec3 axis, float m, vec2 u) {
    vec3 wi = lamp_direction(axis, u);
    return f_lobe(n, wi, wo, m) * L_lamp(axis, wi) * max(0.0, dot(n, wi)) / lamp_density(axis, wi);
}

// The same, wi chosen by lobe_direction(n, wo, m, u)                                     [cd/m²]
float L_r_by_lobe(vec3 n, vec3 wo, vec3 axis, float m, vec2 u) {
    vec3 wi = lobe_direction(n, wo, m, u);
    return f_lobe(n, wi, wo, m) * L_lamp(axis, wi) * max(0.0, dot(n, wi)) / lobe_density(n, wi, wo, m);
}

// The sum of one sample by the lamp, from u, and one by the lobe, from v, each times its weight    [cd/m²]
float L_r_by_both(vec3 n, vec3 wo, vec3 axis, float m, vec2 u, vec2 v) {
    vec3 a = lamp_direction(axis, u), b = lobe_direction(n, wo, m, v);
    return weight(lamp_density(axis, a), lobe_density(n, a, wo, m)) * L_r_by_lamp(n, wo, axis, m, u)
         + weight(lobe_density(n, b, wo, m), lamp_density(axis, b)) * L_r_by_lobe(n, wo, axis, m, v);
}
// end
