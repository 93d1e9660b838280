// solution over_the_area
float L_r_of_sample(Rectangle r, float L_e, vec3 x, vec3 n, float rho, vec2 u) {
    vec3 d = point_on(r, u) - x;
    float d2 = dot(d, d);
    float cos_i = dot(n, d) * inversesqrt(d2);
    float cos_y = -dot(normalize(cross(r.edge_u, r.edge_v)), d) * inversesqrt(d2);
    if (cos_i <= 0.0 || cos_y <= 0.0) return 0.0;
    return rho * L_e * cos_i * cos_y / (pi * d2 * p_area(r));
}
// solution clamped_last
float L_r_of_sample(Rectangle r, float L_e, vec3 x, vec3 n, float rho, vec2 u) {
    vec3 y = point_on(r, u);
    vec3 wi = (y - x) / distance(y, x);
    float p = p_direction(r, x, y);
    if (p == 0.0) return 0.0;
    float E = L_e / p * dot(n, wi);
    return max(E, 0.0) * rho * (1.0 / pi);
}
// mistake cosine_missing
float L_r_of_sample(Rectangle r, float L_e, vec3 x, vec3 n, float rho, vec2 u) {
    vec3 y = point_on(r, u);
    float p = p_direction(r, x, y);
    float cos_i = max(0.0, dot(n, normalize(y - x)));
    return p > 0.0 && cos_i > 0.0 ? rho / pi * L_e / p : 0.0;
}
// mistake pi_missing
float L_r_of_sample(Rectangle r, float L_e, vec3 x, vec3 n, float rho, vec2 u) {
    vec3 y = point_on(r, u);
    float p = p_direction(r, x, y);
    float cos_i = max(0.0, dot(n, normalize(y - x)));
    return p > 0.0 ? rho * L_e * cos_i / p : 0.0;
}
// mistake density_over_area
float L_r_of_sample(Rectangle r, float L_e, vec3 x, vec3 n, float rho, vec2 u) {
    vec3 y = point_on(r, u);
    float p = p_direction(r, x, y);
    float cos_i = max(0.0, dot(n, normalize(y - x)));
    return p > 0.0 ? rho / pi * L_e * cos_i / p_area(r) : 0.0;
}
// mistake times_the_density
float L_r_of_sample(Rectangle r, float L_e, vec3 x, vec3 n, float rho, vec2 u) {
    vec3 y = point_on(r, u);
    float p = p_direction(r, x, y);
    float cos_i = max(0.0, dot(n, normalize(y - x)));
    return rho / pi * L_e * cos_i * p;
}
// mistake density_missing
float L_r_of_sample(Rectangle r, float L_e, vec3 x, vec3 n, float rho, vec2 u) {
    vec3 y = point_on(r, u);
    float p = p_direction(r, x, y);
    float cos_i = max(0.0, dot(n, normalize(y - x)));
    return p > 0.0 ? rho / pi * L_e * cos_i : 0.0;
}
// mistake inverse_square_again
float L_r_of_sample(Rectangle r, float L_e, vec3 x, vec3 n, float rho, vec2 u) {
    vec3 y = point_on(r, u);
    float p = p_direction(r, x, y);
    float cos_i = max(0.0, dot(n, normalize(y - x)));
    return p > 0.0 ? rho / pi * L_e * cos_i / (p * dot(y - x, y - x)) : 0.0;
}
// mistake cosine_of_the_lamp_again
float L_r_of_sample(Rectangle r, float L_e, vec3 x, vec3 n, float rho, vec2 u) {
    vec3 y = point_on(r, u);
    float p = p_direction(r, x, y);
    float cos_i = max(0.0, dot(n, normalize(y - x)));
    float cos_y = dot(normalize(cross(r.edge_u, r.edge_v)), normalize(x - y));
    return p > 0.0 ? rho / pi * L_e * cos_i * cos_y / p : 0.0;
}
// mistake cosine_not_clamped
float L_r_of_sample(Rectangle r, float L_e, vec3 x, vec3 n, float rho, vec2 u) {
    vec3 y = point_on(r, u);
    float p = p_direction(r, x, y);
    float cos_i = dot(n, normalize(y - x));
    return p > 0.0 ? rho / pi * L_e * cos_i / p : 0.0;
}
// mistake direction_not_unit
float L_r_of_sample(Rectangle r, float L_e, vec3 x, vec3 n, float rho, vec2 u) {
    vec3 y = point_on(r, u);
    float p = p_direction(r, x, y);
    float cos_i = max(0.0, dot(n, y - x));
    return p > 0.0 ? rho / pi * L_e * cos_i / p : 0.0;
}
// mistake from_the_lamp
float L_r_of_sample(Rectangle r, float L_e, vec3 x, vec3 n, float rho, vec2 u) {
    vec3 y = point_on(r, u);
    float p = p_direction(r, x, y);
    float cos_i = max(0.0, dot(n, normalize(x - y)));
    return p > 0.0 ? rho / pi * L_e * cos_i / p : 0.0;
}
// mistake divided_by_0
float L_r_of_sample(Rectangle r, float L_e, vec3 x, vec3 n, float rho, vec2 u) {
    vec3 y = point_on(r, u);
    float p = p_direction(r, x, y);
    float cos_i = max(0.0, dot(n, normalize(y - x)));
    return rho / pi * L_e * cos_i / p;
}
