// solution as_a_vector
vec3 edge_vector(vec3 a, vec3 b) { return acos(clamp(dot(a, b), -1.0, 1.0)) * normalize(cross(a, b)); }
float E_rectangle(Rectangle r, float L_e, vec3 x, vec3 n) {
    vec3 v[4] = vec3[4](r.corner, r.corner + r.edge_u, r.corner + r.edge_u + r.edge_v, r.corner + r.edge_v);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < 4; ++i) sum += edge_vector(normalize(v[i] - x), normalize(v[(i + 1) % 4] - x));
    return abs(dot(sum, n)) * L_e / 2.0;
}
// solution without_unit_directions
float edge_part(vec3 a, vec3 b, vec3 n) { return atan(length(cross(a, b)), dot(a, b)) / length(cross(a, b)) * dot(cross(b, a), n); }
float E_rectangle(Rectangle r, float L_e, vec3 x, vec3 n) {
    vec3 a = r.corner - x;
    vec3 b = a + r.edge_v, c = b + r.edge_u, d = a + r.edge_u;
    return L_e * abs(0.5 * (edge_part(a, b, n) + edge_part(b, c, n) + edge_part(c, d, n) + edge_part(d, a, n)));
}
// mistake half_missing
float edge_part(vec3 a, vec3 b, vec3 n) {
    vec3 g = cross(a, b);
    float s = length(g);
    return atan(s, dot(a, b)) * dot(g / s, n);
}
float E_rectangle(Rectangle r, float L_e, vec3 x, vec3 n) {
    vec3 a = normalize(r.corner - x), b = normalize(r.corner + r.edge_v - x);
    vec3 c = normalize(r.corner + r.edge_u + r.edge_v - x), d = normalize(r.corner + r.edge_u - x);
    return L_e * abs(edge_part(a, b, n) + edge_part(b, c, n) + edge_part(c, d, n) + edge_part(d, a, n));
}
// mistake over_2_pi
float edge_part(vec3 a, vec3 b, vec3 n) {
    vec3 g = cross(a, b);
    float s = length(g);
    return atan(s, dot(a, b)) * dot(g / s, n);
}
float E_rectangle(Rectangle r, float L_e, vec3 x, vec3 n) {
    vec3 a = normalize(r.corner - x), b = normalize(r.corner + r.edge_v - x);
    vec3 c = normalize(r.corner + r.edge_u + r.edge_v - x), d = normalize(r.corner + r.edge_u - x);
    return 0.5 / pi * L_e * abs(edge_part(a, b, n) + edge_part(b, c, n) + edge_part(c, d, n) + edge_part(d, a, n));
}
// mistake cross_not_unit
float edge_part(vec3 a, vec3 b, vec3 n) {
    vec3 g = cross(a, b);
    float s = length(g);
    return atan(s, dot(a, b)) * dot(g, n);
}
float E_rectangle(Rectangle r, float L_e, vec3 x, vec3 n) {
    vec3 a = normalize(r.corner - x), b = normalize(r.corner + r.edge_v - x);
    vec3 c = normalize(r.corner + r.edge_u + r.edge_v - x), d = normalize(r.corner + r.edge_u - x);
    return 0.5 * L_e * abs(edge_part(a, b, n) + edge_part(b, c, n) + edge_part(c, d, n) + edge_part(d, a, n));
}
// mistake angle_missing
float edge_part(vec3 a, vec3 b, vec3 n) {
    vec3 g = cross(a, b);
    float s = length(g);
    return dot(g / s, n);
}
float E_rectangle(Rectangle r, float L_e, vec3 x, vec3 n) {
    vec3 a = normalize(r.corner - x), b = normalize(r.corner + r.edge_v - x);
    vec3 c = normalize(r.corner + r.edge_u + r.edge_v - x), d = normalize(r.corner + r.edge_u - x);
    return 0.5 * L_e * abs(edge_part(a, b, n) + edge_part(b, c, n) + edge_part(c, d, n) + edge_part(d, a, n));
}
// mistake sign_of_the_order
float edge_part(vec3 a, vec3 b, vec3 n) {
    vec3 g = cross(a, b);
    float s = length(g);
    return atan(s, dot(a, b)) * dot(g / s, n);
}
float E_rectangle(Rectangle r, float L_e, vec3 x, vec3 n) {
    vec3 a = normalize(r.corner - x), b = normalize(r.corner + r.edge_u - x);
    vec3 c = normalize(r.corner + r.edge_u + r.edge_v - x), d = normalize(r.corner + r.edge_v - x);
    return 0.5 * L_e * (edge_part(a, b, n) + edge_part(b, c, n) + edge_part(c, d, n) + edge_part(d, a, n));
}
// mistake an_edge_missing
float edge_part(vec3 a, vec3 b, vec3 n) {
    vec3 g = cross(a, b);
    float s = length(g);
    return atan(s, dot(a, b)) * dot(g / s, n);
}
float E_rectangle(Rectangle r, float L_e, vec3 x, vec3 n) {
    vec3 a = normalize(r.corner - x), b = normalize(r.corner + r.edge_v - x);
    vec3 c = normalize(r.corner + r.edge_u + r.edge_v - x), d = normalize(r.corner + r.edge_u - x);
    return 0.5 * L_e * abs(edge_part(a, b, n) + edge_part(b, c, n) + edge_part(c, d, n));
}
// mistake absolute_edges
float edge_part(vec3 a, vec3 b, vec3 n) {
    vec3 g = cross(a, b);
    float s = length(g);
    return atan(s, dot(a, b)) * abs(dot(g / s, n));
}
float E_rectangle(Rectangle r, float L_e, vec3 x, vec3 n) {
    vec3 a = normalize(r.corner - x), b = normalize(r.corner + r.edge_v - x);
    vec3 c = normalize(r.corner + r.edge_u + r.edge_v - x), d = normalize(r.corner + r.edge_u - x);
    return 0.5 * L_e * abs(edge_part(a, b, n) + edge_part(b, c, n) + edge_part(c, d, n) + edge_part(d, a, n));
}
// mistake solid_angle_times_cosine
float E_rectangle(Rectangle r, float L_e, vec3 x, vec3 n) {
    vec3 a = normalize(r.corner - x), b = normalize(r.corner + r.edge_u - x);
    vec3 c = normalize(r.corner + r.edge_u + r.edge_v - x), d = normalize(r.corner + r.edge_v - x);
    float abc = 2.0 * atan(abs(dot(a, cross(b, c))), 1.0 + dot(a, b) + dot(b, c) + dot(c, a));
    float acd = 2.0 * atan(abs(dot(a, cross(c, d))), 1.0 + dot(a, c) + dot(c, d) + dot(d, a));
    return L_e * (abc + acd) * max(0.0, dot(n, normalize(r.corner + 0.5 * (r.edge_u + r.edge_v) - x)));
}
