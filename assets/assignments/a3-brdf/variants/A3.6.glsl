// solution over_the_product
float D_stretched(vec3 h, float alpha_t, float alpha_b) {
    float p = alpha_t * alpha_b;
    vec3 v = vec3(alpha_b * h.x, alpha_t * h.y, p * h.z);
    float w2 = p / dot(v, v);
    return p * w2 * w2 / pi;
}
float V_stretched(vec3 wi, vec3 wo, float alpha_t, float alpha_b) {
    float lambda_i = length(vec3(alpha_t * wi.x, alpha_b * wi.y, wi.z)) / wi.z;
    float lambda_o = length(vec3(alpha_t * wo.x, alpha_b * wo.y, wo.z)) / wo.z;
    float G = 2.0 / (lambda_i + lambda_o);
    return G / (4.0 * wi.z * wo.z);
}
// solution term_by_term
float D_stretched(vec3 h, float alpha_t, float alpha_b) {
    float d = h.x * h.x / (alpha_t * alpha_t) + h.y * h.y / (alpha_b * alpha_b) + h.z * h.z;
    return pow(d, -2.0) / pi / alpha_t / alpha_b;
}
float V_stretched(vec3 wi, vec3 wo, float alpha_t, float alpha_b) {
    float s_i = sqrt(alpha_t * alpha_t * wi.x * wi.x + alpha_b * alpha_b * wi.y * wi.y + wi.z * wi.z);
    float s_o = sqrt(alpha_t * alpha_t * wo.x * wo.x + alpha_b * alpha_b * wo.y * wo.y + wo.z * wo.z);
    return 1.0 / (2.0 * wo.z * s_i + 2.0 * wi.z * s_o);
}
// mistake pi_missing
float D_stretched(vec3 h, float alpha_t, float alpha_b) {
    vec3 v = vec3(h.x / alpha_t, h.y / alpha_b, h.z);
    float d = dot(v, v);
    return 1.0 / (alpha_t * alpha_b * d * d);
}
float V_stretched(vec3 wi, vec3 wo, float alpha_t, float alpha_b) {
    vec3 alphas = vec3(alpha_t, alpha_b, 1.0);
    return 0.5 / (wi.z * length(alphas * wo) + wo.z * length(alphas * wi));
}
// mistake widths_missing_in_front
float D_stretched(vec3 h, float alpha_t, float alpha_b) {
    vec3 v = vec3(h.x / alpha_t, h.y / alpha_b, h.z);
    float d = dot(v, v);
    return 1.0 / (pi * d * d);
}
float V_stretched(vec3 wi, vec3 wo, float alpha_t, float alpha_b) {
    vec3 alphas = vec3(alpha_t, alpha_b, 1.0);
    return 0.5 / (wi.z * length(alphas * wo) + wo.z * length(alphas * wi));
}
// mistake denominator_not_squared
float D_stretched(vec3 h, float alpha_t, float alpha_b) {
    vec3 v = vec3(h.x / alpha_t, h.y / alpha_b, h.z);
    float d = dot(v, v);
    return 1.0 / (pi * alpha_t * alpha_b * d);
}
float V_stretched(vec3 wi, vec3 wo, float alpha_t, float alpha_b) {
    vec3 alphas = vec3(alpha_t, alpha_b, 1.0);
    return 0.5 / (wi.z * length(alphas * wo) + wo.z * length(alphas * wi));
}
// mistake one_width
float D_stretched(vec3 h, float alpha_t, float alpha_b) {
    vec3 v = vec3(h.x / alpha_t, h.y / alpha_t, h.z);
    float d = dot(v, v);
    return 1.0 / (pi * alpha_t * alpha_t * d * d);
}
float V_stretched(vec3 wi, vec3 wo, float alpha_t, float alpha_b) {
    vec3 alphas = vec3(alpha_t, alpha_t, 1.0);
    return 0.5 / (wi.z * length(alphas * wo) + wo.z * length(alphas * wi));
}
// mistake widths_swapped
float D_stretched(vec3 h, float alpha_t, float alpha_b) {
    vec3 v = vec3(h.x / alpha_b, h.y / alpha_t, h.z);
    float d = dot(v, v);
    return 1.0 / (pi * alpha_t * alpha_b * d * d);
}
float V_stretched(vec3 wi, vec3 wo, float alpha_t, float alpha_b) {
    vec3 alphas = vec3(alpha_b, alpha_t, 1.0);
    return 0.5 / (wi.z * length(alphas * wo) + wo.z * length(alphas * wi));
}
// mistake times_width
float D_stretched(vec3 h, float alpha_t, float alpha_b) {
    vec3 v = vec3(h.x * alpha_t, h.y * alpha_b, h.z);
    float d = dot(v, v);
    return 1.0 / (pi * alpha_t * alpha_b * d * d);
}
float V_stretched(vec3 wi, vec3 wo, float alpha_t, float alpha_b) {
    vec3 alphas = vec3(alpha_t, alpha_b, 1.0);
    return 0.5 / (wi.z * length(alphas * wo) + wo.z * length(alphas * wi));
}
// mistake widths_not_squared
float D_stretched(vec3 h, float alpha_t, float alpha_b) {
    float d = h.x * h.x / alpha_t + h.y * h.y / alpha_b + h.z * h.z;
    return 1.0 / (pi * alpha_t * alpha_b * d * d);
}
float V_stretched(vec3 wi, vec3 wo, float alpha_t, float alpha_b) {
    vec3 alphas = vec3(alpha_t, alpha_b, 1.0);
    return 0.5 / (wi.z * length(alphas * wo) + wo.z * length(alphas * wi));
}
// mistake over_width
float D_stretched(vec3 h, float alpha_t, float alpha_b) {
    vec3 v = vec3(h.x / alpha_t, h.y / alpha_b, h.z);
    float d = dot(v, v);
    return 1.0 / (pi * alpha_t * alpha_b * d * d);
}
float V_stretched(vec3 wi, vec3 wo, float alpha_t, float alpha_b) {
    vec3 alphas = vec3(1.0 / alpha_t, 1.0 / alpha_b, 1.0);
    return 0.5 / (wi.z * length(alphas * wo) + wo.z * length(alphas * wi));
}
// mistake half_missing
float D_stretched(vec3 h, float alpha_t, float alpha_b) {
    vec3 v = vec3(h.x / alpha_t, h.y / alpha_b, h.z);
    float d = dot(v, v);
    return 1.0 / (pi * alpha_t * alpha_b * d * d);
}
float V_stretched(vec3 wi, vec3 wo, float alpha_t, float alpha_b) {
    vec3 alphas = vec3(alpha_t, alpha_b, 1.0);
    return 1.0 / (wi.z * length(alphas * wo) + wo.z * length(alphas * wi));
}
// mistake factors_swapped
float D_stretched(vec3 h, float alpha_t, float alpha_b) {
    vec3 v = vec3(h.x / alpha_t, h.y / alpha_b, h.z);
    float d = dot(v, v);
    return 1.0 / (pi * alpha_t * alpha_b * d * d);
}
float V_stretched(vec3 wi, vec3 wo, float alpha_t, float alpha_b) {
    vec3 alphas = vec3(alpha_t, alpha_b, 1.0);
    return 0.5 / (wi.z * length(alphas * wi) + wo.z * length(alphas * wo));
}
