// solution by_the_view
float f_phong(vec3 n, vec3 wi, vec3 wo, float k, float m) {
    return k * (m + 2.0) * pow(max(dot(reflect(-wo, n), wi), 0.0), m) / (pi + pi);
}
// solution in_parts
float f_phong(vec3 n, vec3 wi, vec3 wo, float k, float m) {
    float c = 2.0 * dot(n, wi) * dot(n, wo) - dot(wi, wo);
    if (c <= 0.0) return 0.0;
    return k * (0.5 * m + 1.0) / pi * exp2(m * log2(c));
}
// mistake not_normalised
float f_phong(vec3 n, vec3 wi, vec3 wo, float k, float m) {
    return k * pow(max(0.0, dot(reflect(-wi, n), wo)), m);
}
// mistake pi_missing
float f_phong(vec3 n, vec3 wi, vec3 wo, float k, float m) {
    return k * (m + 2.0) / 2.0 * pow(max(0.0, dot(reflect(-wi, n), wo)), m);
}
// mistake cosine_times_reflected
float f_phong(vec3 n, vec3 wi, vec3 wo, float k, float m) {
    return k * (m + 2.0) / (2.0 * pi) * pow(max(0.0, dot(reflect(-wi, n), wo)), m) * dot(n, wi);
}
// mistake divided_by_cosine
float f_phong(vec3 n, vec3 wi, vec3 wo, float k, float m) {
    return k * (m + 2.0) / (2.0 * pi) * pow(max(0.0, dot(reflect(-wi, n), wo)), m) / dot(n, wi);
}
// mistake normalised_without_the_cosine
float f_phong(vec3 n, vec3 wi, vec3 wo, float k, float m) {
    return k * (m + 1.0) / (2.0 * pi) * pow(max(0.0, dot(reflect(-wi, n), wo)), m);
}
// mistake mirror_of_the_wrong_sign
float f_phong(vec3 n, vec3 wi, vec3 wo, float k, float m) {
    return k * (m + 2.0) / (2.0 * pi) * pow(max(0.0, dot(reflect(wi, n), wo)), m);
}
// mistake half_vector
float f_phong(vec3 n, vec3 wi, vec3 wo, float k, float m) {
    return k * (m + 2.0) / (2.0 * pi) * pow(max(0.0, dot(n, normalize(wi + wo))), m);
}
// mistake cosine_not_clamped
float f_phong(vec3 n, vec3 wi, vec3 wo, float k, float m) {
    return k * (m + 2.0) / (2.0 * pi) * pow(abs(dot(reflect(-wi, n), wo)), m);
}
