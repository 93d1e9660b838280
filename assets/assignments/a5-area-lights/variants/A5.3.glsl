// solution other_diagonal
float triangle(vec3 a, vec3 b, vec3 c) {
    return 2.0 * atan(abs(dot(c, cross(a, b))), 1.0 + dot(a, b) + dot(b, c) + dot(c, a));
}
float solid_angle(Rectangle r, vec3 x) {
    vec3 p = r.corner - x;
    vec3 a = normalize(p), b = normalize(p + r.edge_u), c = normalize(p + r.edge_u + r.edge_v), d = normalize(p + r.edge_v);
    return triangle(a, b, d) + triangle(b, c, d);
}
// solution angles_between_planes
float angle_at(vec3 before, vec3 at, vec3 after) {
    vec3 m = cross(at, before), n = cross(at, after);
    return atan(length(cross(m, n)), dot(m, n));
}
float solid_angle(Rectangle r, vec3 x) {
    vec3 a = normalize(r.corner - x), b = normalize(r.corner + r.edge_u - x);
    vec3 c = normalize(r.corner + r.edge_u + r.edge_v - x), d = normalize(r.corner + r.edge_v - x);
    return angle_at(d, a, b) + angle_at(a, b, c) + angle_at(b, c, d) + angle_at(c, d, a) - 2.0 * pi;
}
// solution by_the_plane
float part(float z, vec2 at) { return atan(at.x * at.y, z * sqrt(dot(at, at) + z * z)); }
float solid_angle(Rectangle r, vec3 x) {
    vec3 to_corner = r.corner - x;
    float z = abs(dot(to_corner, normalize(cross(r.edge_u, r.edge_v))));
    vec2 low = vec2(dot(to_corner, normalize(r.edge_u)), dot(to_corner, normalize(r.edge_v)));
    vec2 high = low + vec2(length(r.edge_u), length(r.edge_v));
    return part(z, low) + part(z, high) - part(z, vec2(low.x, high.y)) - part(z, vec2(high.x, low.y));
}
// mistake half_the_angle
float solid_angle(Rectangle r, vec3 x) {
    vec3 a = normalize(r.corner - x), b = normalize(r.corner + r.edge_u - x);
    vec3 c = normalize(r.corner + r.edge_u + r.edge_v - x), d = normalize(r.corner + r.edge_v - x);
    return atan(abs(dot(a, cross(b, c))), 1.0 + dot(a, b) + dot(b, c) + dot(c, a))
         + atan(abs(dot(a, cross(c, d))), 1.0 + dot(a, c) + dot(c, d) + dot(d, a));
}
// mistake one_triangle_twice
float solid_angle(Rectangle r, vec3 x) {
    vec3 a = normalize(r.corner - x), b = normalize(r.corner + r.edge_u - x);
    vec3 c = normalize(r.corner + r.edge_u + r.edge_v - x);
    return 4.0 * atan(abs(dot(a, cross(b, c))), 1.0 + dot(a, b) + dot(b, c) + dot(c, a));
}
// mistake one_triangle
float solid_angle(Rectangle r, vec3 x) {
    vec3 a = normalize(r.corner - x), b = normalize(r.corner + r.edge_u - x);
    vec3 c = normalize(r.corner + r.edge_u + r.edge_v - x);
    return 2.0 * atan(abs(dot(a, cross(b, c))), 1.0 + dot(a, b) + dot(b, c) + dot(c, a));
}
// mistake not_unit
float solid_angle(Rectangle r, vec3 x) {
    vec3 a = r.corner - x, b = r.corner + r.edge_u - x, c = r.corner + r.edge_u + r.edge_v - x, d = r.corner + r.edge_v - x;
    float abc = 2.0 * atan(abs(dot(a, cross(b, c))), 1.0 + dot(a, b) + dot(b, c) + dot(c, a));
    return abc + 2.0 * atan(abs(dot(a, cross(c, d))), 1.0 + dot(a, c) + dot(c, d) + dot(d, a));
}
// mistake triangles_overlap
float solid_angle(Rectangle r, vec3 x) {
    vec3 a = normalize(r.corner - x), b = normalize(r.corner + r.edge_u - x);
    vec3 c = normalize(r.corner + r.edge_u + r.edge_v - x), d = normalize(r.corner + r.edge_v - x);
    return 2.0 * atan(abs(dot(a, cross(b, c))), 1.0 + dot(a, b) + dot(b, c) + dot(c, a))
         + 2.0 * atan(abs(dot(a, cross(b, d))), 1.0 + dot(a, b) + dot(b, d) + dot(d, a));
}
// mistake area_over_squared_distance
float solid_angle(Rectangle r, vec3 x) {
    vec3 to_center = r.corner + 0.5 * (r.edge_u + r.edge_v) - x;
    return length(r.edge_u) * length(r.edge_v) / dot(to_center, to_center);
}
// mistake from_the_center_alone
float solid_angle(Rectangle r, vec3 x) {
    vec3 to_center = r.corner + 0.5 * (r.edge_u + r.edge_v) - x;
    return abs(dot(cross(r.edge_u, r.edge_v), normalize(to_center))) / dot(to_center, to_center);
}
// mistake sign_by_order
float solid_angle(Rectangle r, vec3 x) {
    vec3 a = normalize(r.corner - x), b = normalize(r.corner + r.edge_u - x);
    vec3 c = normalize(r.corner + r.edge_u + r.edge_v - x), d = normalize(r.corner + r.edge_v - x);
    return 2.0 * atan(dot(a, cross(b, c)), 1.0 + dot(a, b) + dot(b, c) + dot(c, a))
         + 2.0 * atan(dot(a, cross(c, d)), 1.0 + dot(a, c) + dot(c, d) + dot(d, a));
}
// mistake degrees
float solid_angle(Rectangle r, vec3 x) {
    vec3 a = normalize(r.corner - x), b = normalize(r.corner + r.edge_u - x);
    vec3 c = normalize(r.corner + r.edge_u + r.edge_v - x), d = normalize(r.corner + r.edge_v - x);
    float abc = 2.0 * atan(abs(dot(a, cross(b, c))), 1.0 + dot(a, b) + dot(b, c) + dot(c, a));
    return degrees(abc + 2.0 * atan(abs(dot(a, cross(c, d))), 1.0 + dot(a, c) + dot(c, d) + dot(d, a)));
}
