// solution by_mix
vec3 point_on(Rectangle r, vec2 u) {
    vec3 low = mix(r.corner, r.corner + r.edge_u, u.x);
    vec3 high = mix(r.corner + r.edge_v, r.corner + r.edge_u + r.edge_v, u.x);
    return mix(low, high, u.y);
}
float p_area(Rectangle r) { return inversesqrt(dot(r.edge_u, r.edge_u)) * inversesqrt(dot(r.edge_v, r.edge_v)); }
// solution by_the_cross_product
vec3 point_on(Rectangle r, vec2 u) { return mat3(r.edge_u, r.edge_v, r.corner) * vec3(u, 1.0); }
float p_area(Rectangle r) { return 1.0 / length(cross(r.edge_u, r.edge_v)); }
// mistake around_the_corner
vec3 point_on(Rectangle r, vec2 u) { return r.corner + (u.x - 0.5) * r.edge_u + (u.y - 0.5) * r.edge_v; }
float p_area(Rectangle r) { return 1.0 / (length(r.edge_u) * length(r.edge_v)); }
// mistake edges_exchanged
vec3 point_on(Rectangle r, vec2 u) { return r.corner + u.y * r.edge_u + u.x * r.edge_v; }
float p_area(Rectangle r) { return 1.0 / (length(r.edge_u) * length(r.edge_v)); }
// mistake on_the_diagonal
vec3 point_on(Rectangle r, vec2 u) { return r.corner + u.x * (r.edge_u + r.edge_v); }
float p_area(Rectangle r) { return 1.0 / (length(r.edge_u) * length(r.edge_v)); }
// mistake edges_of_length_1
vec3 point_on(Rectangle r, vec2 u) { return r.corner + u.x * normalize(r.edge_u) + u.y * normalize(r.edge_v); }
float p_area(Rectangle r) { return 1.0 / (length(r.edge_u) * length(r.edge_v)); }
// mistake without_the_corner
vec3 point_on(Rectangle r, vec2 u) { return u.x * r.edge_u + u.y * r.edge_v; }
float p_area(Rectangle r) { return 1.0 / (length(r.edge_u) * length(r.edge_v)); }
// mistake area_for_density
vec3 point_on(Rectangle r, vec2 u) { return r.corner + u.x * r.edge_u + u.y * r.edge_v; }
float p_area(Rectangle r) { return length(r.edge_u) * length(r.edge_v); }
// mistake squared_edges
vec3 point_on(Rectangle r, vec2 u) { return r.corner + u.x * r.edge_u + u.y * r.edge_v; }
float p_area(Rectangle r) { return 1.0 / (dot(r.edge_u, r.edge_u) * dot(r.edge_v, r.edge_v)); }
// mistake half_the_area
vec3 point_on(Rectangle r, vec2 u) { return r.corner + u.x * r.edge_u + u.y * r.edge_v; }
float p_area(Rectangle r) { return 2.0 / (length(r.edge_u) * length(r.edge_v)); }
