// solution by_the_cross_product
float p_direction(Rectangle r, vec3 x, vec3 y) {
    float d = distance(x, y);
    float towards = dot(cross(r.edge_u, r.edge_v), x - y);
    if (towards <= 0.0) return 0.0;
    return d * d * d / towards;
}
// solution from_x_to_y
float p_direction(Rectangle r, vec3 x, vec3 y) {
    vec3 wi = normalize(y - x);
    vec3 n_y = normalize(cross(r.edge_u, r.edge_v));
    float cos_y = max(0.0, -dot(n_y, wi));
    return cos_y == 0.0 ? 0.0 : dot(y - x, y - x) / cos_y * p_area(r);
}
// mistake density_over_area
float p_direction(Rectangle r, vec3 x, vec3 y) {
    return dot(cross(r.edge_u, r.edge_v), x - y) > 0.0 ? p_area(r) : 0.0;
}
// mistake upside_down
float p_direction(Rectangle r, vec3 x, vec3 y) {
    vec3 to_x = x - y;
    float d2 = dot(to_x, to_x);
    float cos_y = dot(normalize(cross(r.edge_u, r.edge_v)), to_x / sqrt(d2));
    return cos_y > 0.0 ? p_area(r) * cos_y / d2 : 0.0;
}
// mistake distance_not_squared
float p_direction(Rectangle r, vec3 x, vec3 y) {
    vec3 to_x = x - y;
    float cos_y = dot(normalize(cross(r.edge_u, r.edge_v)), normalize(to_x));
    return cos_y > 0.0 ? p_area(r) * length(to_x) / cos_y : 0.0;
}
// mistake cosine_missing
float p_direction(Rectangle r, vec3 x, vec3 y) {
    vec3 to_x = x - y;
    return dot(cross(r.edge_u, r.edge_v), to_x) > 0.0 ? p_area(r) * dot(to_x, to_x) : 0.0;
}
// mistake cosine_in_the_numerator
float p_direction(Rectangle r, vec3 x, vec3 y) {
    vec3 to_x = x - y;
    return max(0.0, p_area(r) * dot(to_x, to_x) * dot(normalize(cross(r.edge_u, r.edge_v)), normalize(to_x)));
}
// mistake normal_not_unit
float p_direction(Rectangle r, vec3 x, vec3 y) {
    vec3 to_x = x - y;
    float cos_y = dot(cross(r.edge_u, r.edge_v), normalize(to_x));
    return cos_y > 0.0 ? p_area(r) * dot(to_x, to_x) / cos_y : 0.0;
}
// mistake both_sides
float p_direction(Rectangle r, vec3 x, vec3 y) {
    vec3 to_x = x - y;
    float cos_y = abs(dot(normalize(cross(r.edge_u, r.edge_v)), normalize(to_x)));
    return p_area(r) * dot(to_x, to_x) / cos_y;
}
// mistake away_from_x
float p_direction(Rectangle r, vec3 x, vec3 y) {
    vec3 d = y - x;
    float cos_y = dot(normalize(cross(r.edge_u, r.edge_v)), normalize(d));
    return cos_y > 0.0 ? p_area(r) * dot(d, d) / cos_y : 0.0;
}
// mistake area_for_density
float p_direction(Rectangle r, vec3 x, vec3 y) {
    vec3 to_x = x - y;
    float cos_y = dot(normalize(cross(r.edge_u, r.edge_v)), normalize(to_x));
    return cos_y > 0.0 ? dot(to_x, to_x) / (p_area(r) * cos_y) : 0.0;
}
