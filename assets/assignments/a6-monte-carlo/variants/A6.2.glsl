// solution by_logarithms
float lobe_density(vec3 n, vec3 wi, vec3 wo, float m) {
    float cos_g = 2.0 * dot(n, wi) * dot(n, wo) - dot(wi, wo);
    if (cos_g <= 0.0) return 0.0;
    return exp2(m * log2(cos_g)) * (0.5 * m + 0.5) / pi;
}
vec3 lobe_direction(vec3 n, vec3 wo, float m, vec2 u) {
    float z = exp2(log2(u.x) / (1.0 + m));
    float s = sqrt((1.0 - z) * (1.0 + z));
    return frame_around(2.0 * dot(n, wo) * n - wo) * vec3(s * sin(2.0 * pi * u.y), s * cos(2.0 * pi * u.y), z);
}
// solution numbers_exchanged
float lobe_density(vec3 n, vec3 wi, vec3 wo, float m) {
    return (m + 1.0) * pow(max(0.0, dot(reflect(-wi, n), wo)), m) / (pi + pi);
}
vec3 lobe_direction(vec3 n, vec3 wo, float m, vec2 u) {
    vec3 r = reflect(-wo, n);
    vec3 t = normalize(cross(r, abs(r.x) < 0.5 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0)));
    float z = pow(u.y, 1.0 / (m + 1.0)), phi = -2.0 * pi * u.x;
    return z * r + sqrt(max(0.0, 1.0 - z * z)) * (cos(phi) * t + sin(phi) * cross(r, t));
}
// mistake factor_of_f_r
float lobe_density(vec3 n, vec3 wi, vec3 wo, float m) {
    float cos_g = dot(reflect(-wo, n), wi);
    return cos_g > 0.0 ? (m + 2.0) / (2.0 * pi) * pow(cos_g, m) : 0.0;
}
vec3 lobe_direction(vec3 n, vec3 wo, float m, vec2 u) {
    float z = pow(1.0 - u.x, 1.0 / (m + 1.0)), phi = 2.0 * pi * u.y;
    float s = sqrt(max(0.0, 1.0 - z * z));
    return frame_around(reflect(-wo, n)) * vec3(s * cos(phi), s * sin(phi), z);
}
// mistake pi_missing
float lobe_density(vec3 n, vec3 wi, vec3 wo, float m) {
    float cos_g = dot(reflect(-wo, n), wi);
    return cos_g > 0.0 ? (m + 1.0) / 2.0 * pow(cos_g, m) : 0.0;
}
vec3 lobe_direction(vec3 n, vec3 wo, float m, vec2 u) {
    float z = pow(1.0 - u.x, 1.0 / (m + 1.0)), phi = 2.0 * pi * u.y;
    float s = sqrt(max(0.0, 1.0 - z * z));
    return frame_around(reflect(-wo, n)) * vec3(s * cos(phi), s * sin(phi), z);
}
// mistake not_normalised
float lobe_density(vec3 n, vec3 wi, vec3 wo, float m) {
    float cos_g = dot(reflect(-wo, n), wi);
    return cos_g > 0.0 ? pow(cos_g, m) : 0.0;
}
vec3 lobe_direction(vec3 n, vec3 wo, float m, vec2 u) {
    float z = pow(1.0 - u.x, 1.0 / (m + 1.0)), phi = 2.0 * pi * u.y;
    float s = sqrt(max(0.0, 1.0 - z * z));
    return frame_around(reflect(-wo, n)) * vec3(s * cos(phi), s * sin(phi), z);
}
// mistake cosine_in_the_density
float lobe_density(vec3 n, vec3 wi, vec3 wo, float m) {
    float cos_g = dot(reflect(-wo, n), wi);
    return cos_g > 0.0 ? (m + 1.0) / (2.0 * pi) * pow(cos_g, m) * max(0.0, dot(n, wi)) : 0.0;
}
vec3 lobe_direction(vec3 n, vec3 wo, float m, vec2 u) {
    float z = pow(1.0 - u.x, 1.0 / (m + 1.0)), phi = 2.0 * pi * u.y;
    float s = sqrt(max(0.0, 1.0 - z * z));
    return frame_around(reflect(-wo, n)) * vec3(s * cos(phi), s * sin(phi), z);
}
// mistake half_vector
float lobe_density(vec3 n, vec3 wi, vec3 wo, float m) {
    float cos_g = dot(n, normalize(wi + wo));
    return cos_g > 0.0 ? (m + 1.0) / (2.0 * pi) * pow(cos_g, m) : 0.0;
}
vec3 lobe_direction(vec3 n, vec3 wo, float m, vec2 u) {
    float z = pow(1.0 - u.x, 1.0 / (m + 1.0)), phi = 2.0 * pi * u.y;
    float s = sqrt(max(0.0, 1.0 - z * z));
    return frame_around(reflect(-wo, n)) * vec3(s * cos(phi), s * sin(phi), z);
}
// mistake one_over_m
float lobe_density(vec3 n, vec3 wi, vec3 wo, float m) {
    float cos_g = dot(reflect(-wo, n), wi);
    return cos_g > 0.0 ? (m + 1.0) / (2.0 * pi) * pow(cos_g, m) : 0.0;
}
vec3 lobe_direction(vec3 n, vec3 wo, float m, vec2 u) {
    float z = pow(1.0 - u.x, 1.0 / m), phi = 2.0 * pi * u.y;
    float s = sqrt(max(0.0, 1.0 - z * z));
    return frame_around(reflect(-wo, n)) * vec3(s * cos(phi), s * sin(phi), z);
}
// mistake power_not_root
float lobe_density(vec3 n, vec3 wi, vec3 wo, float m) {
    float cos_g = dot(reflect(-wo, n), wi);
    return cos_g > 0.0 ? (m + 1.0) / (2.0 * pi) * pow(cos_g, m) : 0.0;
}
vec3 lobe_direction(vec3 n, vec3 wo, float m, vec2 u) {
    float z = pow(1.0 - u.x, m + 1.0), phi = 2.0 * pi * u.y;
    float s = sqrt(max(0.0, 1.0 - z * z));
    return frame_around(reflect(-wo, n)) * vec3(s * cos(phi), s * sin(phi), z);
}
// mistake around_n
float lobe_density(vec3 n, vec3 wi, vec3 wo, float m) {
    float cos_g = dot(reflect(-wo, n), wi);
    return cos_g > 0.0 ? (m + 1.0) / (2.0 * pi) * pow(cos_g, m) : 0.0;
}
vec3 lobe_direction(vec3 n, vec3 wo, float m, vec2 u) {
    float z = pow(1.0 - u.x, 1.0 / (m + 1.0)), phi = 2.0 * pi * u.y;
    float s = sqrt(max(0.0, 1.0 - z * z));
    return frame_around(n) * vec3(s * cos(phi), s * sin(phi), z);
}
// mistake around_wo
float lobe_density(vec3 n, vec3 wi, vec3 wo, float m) {
    float cos_g = dot(reflect(-wo, n), wi);
    return cos_g > 0.0 ? (m + 1.0) / (2.0 * pi) * pow(cos_g, m) : 0.0;
}
vec3 lobe_direction(vec3 n, vec3 wo, float m, vec2 u) {
    float z = pow(1.0 - u.x, 1.0 / (m + 1.0)), phi = 2.0 * pi * u.y;
    float s = sqrt(max(0.0, 1.0 - z * z));
    return frame_around(wo) * vec3(s * cos(phi), s * sin(phi), z);
}
// mistake mirror_of_the_wrong_sign
float lobe_density(vec3 n, vec3 wi, vec3 wo, float m) {
    float cos_g = dot(reflect(-wo, n), wi);
    return cos_g > 0.0 ? (m + 1.0) / (2.0 * pi) * pow(cos_g, m) : 0.0;
}
vec3 lobe_direction(vec3 n, vec3 wo, float m, vec2 u) {
    float z = pow(1.0 - u.x, 1.0 / (m + 1.0)), phi = 2.0 * pi * u.y;
    float s = sqrt(max(0.0, 1.0 - z * z));
    return frame_around(reflect(wo, n)) * vec3(s * cos(phi), s * sin(phi), z);
}
