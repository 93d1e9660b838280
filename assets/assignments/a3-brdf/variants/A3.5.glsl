// solution half_of_the_sum
vec3 f_ggx(vec3 n, vec3 wi, vec3 wo, vec3 F0, float alpha) {
    vec3 s = wi + wo;
    float inverse = inversesqrt(dot(s, s));
    return V(dot(n, wo), dot(n, wi), alpha) * D(dot(n, s) * inverse, alpha) * F(dot(wo, s) * inverse, F0);
}
// solution cosines_first
vec3 f_ggx(vec3 n, vec3 wi, vec3 wo, vec3 F0, float alpha) {
    float cos_i = dot(n, wi), cos_o = dot(n, wo);
    float cos_d = sqrt(0.5 + 0.5 * dot(wi, wo));
    return F(cos_d, F0) * (D((cos_i + cos_o) / (2.0 * cos_d), alpha) * V(cos_i, cos_o, alpha));
}
// mistake half_not_normalised
vec3 f_ggx(vec3 n, vec3 wi, vec3 wo, vec3 F0, float alpha) {
    vec3 h = 0.5 * (wi + wo);
    return D(dot(n, h), alpha) * V(dot(n, wi), dot(n, wo), alpha) * F(dot(wi, h), F0);
}
// mistake half_of_the_difference
vec3 f_ggx(vec3 n, vec3 wi, vec3 wo, vec3 F0, float alpha) {
    vec3 h = normalize(wi - wo);
    return D(dot(n, h), alpha) * V(dot(n, wi), dot(n, wo), alpha) * F(dot(wi, h), F0);
}
// mistake cosine_times_reflected
vec3 f_ggx(vec3 n, vec3 wi, vec3 wo, vec3 F0, float alpha) {
    vec3 h = normalize(wi + wo);
    return D(dot(n, h), alpha) * V(dot(n, wi), dot(n, wo), alpha) * F(dot(wi, h), F0) * dot(n, wi);
}
// mistake divided_by_four_cosines_again
vec3 f_ggx(vec3 n, vec3 wi, vec3 wo, vec3 F0, float alpha) {
    vec3 h = normalize(wi + wo);
    float cos_i = dot(n, wi), cos_o = dot(n, wo);
    return D(dot(n, h), alpha) * V(cos_i, cos_o, alpha) * F(dot(wi, h), F0) / (4.0 * cos_i * cos_o);
}
// mistake fresnel_of_the_normal
vec3 f_ggx(vec3 n, vec3 wi, vec3 wo, vec3 F0, float alpha) {
    vec3 h = normalize(wi + wo);
    return D(dot(n, h), alpha) * V(dot(n, wi), dot(n, wo), alpha) * F(dot(n, wi), F0);
}
// mistake width_squared_again
vec3 f_ggx(vec3 n, vec3 wi, vec3 wo, vec3 F0, float alpha) {
    vec3 h = normalize(wi + wo);
    float a = alpha * alpha;
    return D(dot(n, h), a) * V(dot(n, wi), dot(n, wo), a) * F(dot(wi, h), F0);
}
// mistake fresnel_missing
vec3 f_ggx(vec3 n, vec3 wi, vec3 wo, vec3 F0, float alpha) {
    vec3 h = normalize(wi + wo);
    return vec3(D(dot(n, h), alpha) * V(dot(n, wi), dot(n, wo), alpha));
}
