// solution densities_once
float term(vec3 n, vec3 wi, vec3 wo, vec3 axis, float m) {
    return f_lobe(n, wi, wo, m) * L_lamp(axis, wi) * max(0.0, dot(n, wi));
}
float L_r_by_lamp(vec3 n, vec3 wo, vec3 axis, float m, vec2 u) {
    vec3 wi = lamp_direction(axis, u);
    return 2.0 * pi * (1.0 - cos(lamp_angle)) * term(n, wi, wo, axis, m);
}
float L_r_by_lobe(vec3 n, vec3 wo, vec3 axis, float m, vec2 u) {
    vec3 wi = lobe_direction(n, wo, m, u); // f_r / p is (m + 2) / (m + 1)
    return (m + 2.0) / (m + 1.0) * L_lamp(axis, wi) * max(0.0, dot(n, wi));
}
float L_r_by_both(vec3 n, vec3 wo, vec3 axis, float m, vec2 u, vec2 v) {
    vec3 a = lamp_direction(axis, u), b = lobe_direction(n, wo, m, v);
    float p = lamp_density(axis, a), q = lobe_density(n, a, wo, m);
    float sum = term(n, a, wo, axis, m) * p / (p * p + q * q);
    if (L_lamp(axis, b) == 0.0) return sum;
    p = lamp_density(axis, b);
    q = lobe_density(n, b, wo, m);
    return sum + term(n, b, wo, axis, m) * q / (p * p + q * q);
}
// solution weights_of_each_other
float L_r_by_lamp(vec3 n, vec3 wo, vec3 axis, float m, vec2 u) {
    vec3 wi = lamp_direction(axis, u);
    float cos_i = dot(n, wi);
    if (cos_i <= 0.0) return 0.0;
    return cos_i / lamp_density(axis, wi) * f_lobe(n, wi, wo, m);
}
float L_r_by_lobe(vec3 n, vec3 wo, vec3 axis, float m, vec2 u) {
    vec3 wi = lobe_direction(n, wo, m, u);
    float cos_i = dot(n, wi), p = lobe_density(n, wi, wo, m);
    return cos_i > 0.0 && p > 0.0 ? L_lamp(axis, wi) * cos_i * (f_lobe(n, wi, wo, m) / p) : 0.0;
}
float L_r_by_both(vec3 n, vec3 wo, vec3 axis, float m, vec2 u, vec2 v) {
    vec3 a = lamp_direction(axis, u), b = lobe_direction(n, wo, m, v);
    float of_a = weight(lobe_density(n, a, wo, m), lamp_density(axis, a));
    float of_b = 1.0 - weight(lamp_density(axis, b), lobe_density(n, b, wo, m));
    return mix(L_r_by_lamp(n, wo, axis, m, u), 0.0, of_a) + of_b * L_r_by_lobe(n, wo, axis, m, v);
}
// mistake cosine_missing
float L_r_by_lamp(vec3 n, vec3 wo, vec3 axis, float m, vec2 u) {
    vec3 wi = lamp_direction(axis, u);
    return f_lobe(n, wi, wo, m) * L_lamp(axis, wi) * float(dot(n, wi) > 0.0) / lamp_density(axis, wi);
}
float L_r_by_lobe(vec3 n, vec3 wo, vec3 axis, float m, vec2 u) {
    vec3 wi = lobe_direction(n, wo, m, u);
    return f_lobe(n, wi, wo, m) * L_lamp(axis, wi) * float(dot(n, wi) > 0.0) / lobe_density(n, wi, wo, m);
}
float L_r_by_both(vec3 n, vec3 wo, vec3 axis, float m, vec2 u, vec2 v) {
    vec3 a = lamp_direction(axis, u), b = lobe_direction(n, wo, m, v);
    return weight(lamp_density(axis, a), lobe_density(n, a, wo, m)) * L_r_by_lamp(n, wo, axis, m, u)
         + weight(lobe_density(n, b, wo, m), lamp_density(axis, b)) * L_r_by_lobe(n, wo, axis, m, v);
}
// mistake cosine_not_clamped
float L_r_by_lamp(vec3 n, vec3 wo, vec3 axis, float m, vec2 u) {
    vec3 wi = lamp_direction(axis, u);
    return f_lobe(n, wi, wo, m) * L_lamp(axis, wi) * dot(n, wi) / lamp_density(axis, wi);
}
float L_r_by_lobe(vec3 n, vec3 wo, vec3 axis, float m, vec2 u) {
    vec3 wi = lobe_direction(n, wo, m, u);
    return f_lobe(n, wi, wo, m) * L_lamp(axis, wi) * dot(n, wi) / lobe_density(n, wi, wo, m);
}
float L_r_by_both(vec3 n, vec3 wo, vec3 axis, float m, vec2 u, vec2 v) {
    vec3 a = lamp_direction(axis, u), b = lobe_direction(n, wo, m, v);
    return weight(lamp_density(axis, a), lobe_density(n, a, wo, m)) * L_r_by_lamp(n, wo, axis, m, u)
         + weight(lobe_density(n, b, wo, m), lamp_density(axis, b)) * L_r_by_lobe(n, wo, axis, m, v);
}
// mistake f_r_missing
float L_r_by_lamp(vec3 n, vec3 wo, vec3 axis, float m, vec2 u) {
    vec3 wi = lamp_direction(axis, u);
    return L_lamp(axis, wi) * max(0.0, dot(n, wi)) / lamp_density(axis, wi);
}
float L_r_by_lobe(vec3 n, vec3 wo, vec3 axis, float m, vec2 u) {
    vec3 wi = lobe_direction(n, wo, m, u);
    return L_lamp(axis, wi) * max(0.0, dot(n, wi)) / lobe_density(n, wi, wo, m);
}
float L_r_by_both(vec3 n, vec3 wo, vec3 axis, float m, vec2 u, vec2 v) {
    vec3 a = lamp_direction(axis, u), b = lobe_direction(n, wo, m, v);
    return weight(lamp_density(axis, a), lobe_density(n, a, wo, m)) * L_r_by_lamp(n, wo, axis, m, u)
         + weight(lobe_density(n, b, wo, m), lamp_density(axis, b)) * L_r_by_lobe(n, wo, axis, m, v);
}
// mistake densities_exchanged
float L_r_by_lamp(vec3 n, vec3 wo, vec3 axis, float m, vec2 u) {
    vec3 wi = lamp_direction(axis, u);
    return f_lobe(n, wi, wo, m) * L_lamp(axis, wi) * max(0.0, dot(n, wi)) / lobe_density(n, wi, wo, m);
}
float L_r_by_lobe(vec3 n, vec3 wo, vec3 axis, float m, vec2 u) {
    vec3 wi = lobe_direction(n, wo, m, u);
    return f_lobe(n, wi, wo, m) * L_lamp(axis, wi) * max(0.0, dot(n, wi)) / lamp_density(axis, wi);
}
float L_r_by_both(vec3 n, vec3 wo, vec3 axis, float m, vec2 u, vec2 v) {
    vec3 a = lamp_direction(axis, u), b = lobe_direction(n, wo, m, v);
    return weight(lamp_density(axis, a), lobe_density(n, a, wo, m)) * L_r_by_lamp(n, wo, axis, m, u)
         + weight(lobe_density(n, b, wo, m), lamp_density(axis, b)) * L_r_by_lobe(n, wo, axis, m, v);
}
// mistake times_the_density
float L_r_by_lamp(vec3 n, vec3 wo, vec3 axis, float m, vec2 u) {
    vec3 wi = lamp_direction(axis, u);
    return f_lobe(n, wi, wo, m) * L_lamp(axis, wi) * max(0.0, dot(n, wi)) * lamp_density(axis, wi);
}
float L_r_by_lobe(vec3 n, vec3 wo, vec3 axis, float m, vec2 u) {
    vec3 wi = lobe_direction(n, wo, m, u);
    return f_lobe(n, wi, wo, m) * L_lamp(axis, wi) * max(0.0, dot(n, wi)) * lobe_density(n, wi, wo, m);
}
float L_r_by_both(vec3 n, vec3 wo, vec3 axis, float m, vec2 u, vec2 v) {
    vec3 a = lamp_direction(axis, u), b = lobe_direction(n, wo, m, v);
    return weight(lamp_density(axis, a), lobe_density(n, a, wo, m)) * L_r_by_lamp(n, wo, axis, m, u)
         + weight(lobe_density(n, b, wo, m), lamp_density(axis, b)) * L_r_by_lobe(n, wo, axis, m, v);
}
// mistake density_missing
float L_r_by_lamp(vec3 n, vec3 wo, vec3 axis, float m, vec2 u) {
    vec3 wi = lamp_direction(axis, u);
    return f_lobe(n, wi, wo, m) * L_lamp(axis, wi) * max(0.0, dot(n, wi));
}
float L_r_by_lobe(vec3 n, vec3 wo, vec3 axis, float m, vec2 u) {
    vec3 wi = lobe_direction(n, wo, m, u);
    return f_lobe(n, wi, wo, m) * L_lamp(axis, wi) * max(0.0, dot(n, wi));
}
float L_r_by_both(vec3 n, vec3 wo, vec3 axis, float m, vec2 u, vec2 v) {
    vec3 a = lamp_direction(axis, u), b = lobe_direction(n, wo, m, v);
    return weight(lamp_density(axis, a), lobe_density(n, a, wo, m)) * L_r_by_lamp(n, wo, axis, m, u)
         + weight(lobe_density(n, b, wo, m), lamp_density(axis, b)) * L_r_by_lobe(n, wo, axis, m, v);
}
// mistake weights_missing
float L_r_by_lamp(vec3 n, vec3 wo, vec3 axis, float m, vec2 u) {
    vec3 wi = lamp_direction(axis, u);
    return f_lobe(n, wi, wo, m) * L_lamp(axis, wi) * max(0.0, dot(n, wi)) / lamp_density(axis, wi);
}
float L_r_by_lobe(vec3 n, vec3 wo, vec3 axis, float m, vec2 u) {
    vec3 wi = lobe_direction(n, wo, m, u);
    return f_lobe(n, wi, wo, m) * L_lamp(axis, wi) * max(0.0, dot(n, wi)) / lobe_density(n, wi, wo, m);
}
float L_r_by_both(vec3 n, vec3 wo, vec3 axis, float m, vec2 u, vec2 v) {
    vec3 a = lamp_direction(axis, u), b = lobe_direction(n, wo, m, v);
    return L_r_by_lamp(n, wo, axis, m, u)
         + L_r_by_lobe(n, wo, axis, m, v);
}
// mistake half_of_each
float L_r_by_lamp(vec3 n, vec3 wo, vec3 axis, float m, vec2 u) {
    vec3 wi = lamp_direction(axis, u);
    return f_lobe(n, wi, wo, m) * L_lamp(axis, wi) * max(0.0, dot(n, wi)) / lamp_density(axis, wi);
}
float L_r_by_lobe(vec3 n, vec3 wo, vec3 axis, float m, vec2 u) {
    vec3 wi = lobe_direction(n, wo, m, u);
    return f_lobe(n, wi, wo, m) * L_lamp(axis, wi) * max(0.0, dot(n, wi)) / lobe_density(n, wi, wo, m);
}
float L_r_by_both(vec3 n, vec3 wo, vec3 axis, float m, vec2 u, vec2 v) {
    vec3 a = lamp_direction(axis, u), b = lobe_direction(n, wo, m, v);
    return 0.5 * L_r_by_lamp(n, wo, axis, m, u)
         + 0.5 * L_r_by_lobe(n, wo, axis, m, v);
}
// mistake weights_exchanged
float L_r_by_lamp(vec3 n, vec3 wo, vec3 axis, float m, vec2 u) {
    vec3 wi = lamp_direction(axis, u);
    return f_lobe(n, wi, wo, m) * L_lamp(axis, wi) * max(0.0, dot(n, wi)) / lamp_density(axis, wi);
}
float L_r_by_lobe(vec3 n, vec3 wo, vec3 axis, float m, vec2 u) {
    vec3 wi = lobe_direction(n, wo, m, u);
    return f_lobe(n, wi, wo, m) * L_lamp(axis, wi) * max(0.0, dot(n, wi)) / lobe_density(n, wi, wo, m);
}
float L_r_by_both(vec3 n, vec3 wo, vec3 axis, float m, vec2 u, vec2 v) {
    vec3 a = lamp_direction(axis, u), b = lobe_direction(n, wo, m, v);
    return weight(lobe_density(n, a, wo, m), lamp_density(axis, a)) * L_r_by_lamp(n, wo, axis, m, u)
         + weight(lamp_density(axis, b), lobe_density(n, b, wo, m)) * L_r_by_lobe(n, wo, axis, m, v);
}
// mistake density_of_the_other_direction
float L_r_by_lamp(vec3 n, vec3 wo, vec3 axis, float m, vec2 u) {
    vec3 wi = lamp_direction(axis, u);
    return f_lobe(n, wi, wo, m) * L_lamp(axis, wi) * max(0.0, dot(n, wi)) / lamp_density(axis, wi);
}
float L_r_by_lobe(vec3 n, vec3 wo, vec3 axis, float m, vec2 u) {
    vec3 wi = lobe_direction(n, wo, m, u);
    return f_lobe(n, wi, wo, m) * L_lamp(axis, wi) * max(0.0, dot(n, wi)) / lobe_density(n, wi, wo, m);
}
float L_r_by_both(vec3 n, vec3 wo, vec3 axis, float m, vec2 u, vec2 v) {
    vec3 a = lamp_direction(axis, u), b = lobe_direction(n, wo, m, v);
    return weight(lamp_density(axis, a), lobe_density(n, b, wo, m)) * L_r_by_lamp(n, wo, axis, m, u)
         + weight(lobe_density(n, b, wo, m), lamp_density(axis, a)) * L_r_by_lobe(n, wo, axis, m, v);
}
// mistake lamp_not_asked
float L_r_by_lamp(vec3 n, vec3 wo, vec3 axis, float m, vec2 u) {
    vec3 wi = lamp_direction(axis, u);
    return f_lobe(n, wi, wo, m) * max(0.0, dot(n, wi)) / lamp_density(axis, wi);
}
float L_r_by_lobe(vec3 n, vec3 wo, vec3 axis, float m, vec2 u) {
    vec3 wi = lobe_direction(n, wo, m, u);
    return f_lobe(n, wi, wo, m) * max(0.0, dot(n, wi)) / lobe_density(n, wi, wo, m);
}
float L_r_by_both(vec3 n, vec3 wo, vec3 axis, float m, vec2 u, vec2 v) {
    vec3 a = lamp_direction(axis, u), b = lobe_direction(n, wo, m, v);
    return weight(lamp_density(axis, a), lobe_density(n, a, wo, m)) * L_r_by_lamp(n, wo, axis, m, u)
         + weight(lobe_density(n, b, wo, m), lamp_density(axis, b)) * L_r_by_lobe(n, wo, axis, m, v);
}
