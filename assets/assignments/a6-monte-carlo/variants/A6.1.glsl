// solution normal_and_sphere
float cosine_density(vec3 n, vec3 wi) { return dot(n, wi) > 0.0 ? dot(n, wi) * 0.31830989 : 0.0; }
vec3 cosine_direction(vec3 n, vec2 u) {
    float z = 1.0 - 2.0 * u.x, phi = 2.0 * pi * u.y;
    vec3 s = vec3(sqrt(max(0.0, 1.0 - z * z)) * vec2(cos(phi), sin(phi)), z);
    return normalize(n + s); // a sphere that touches the surface from above
}
// solution by_the_angle
float cosine_density(vec3 n, vec3 wi) { return 0.5 * (dot(n, wi) + abs(dot(n, wi))) / pi; }
vec3 cosine_direction(vec3 n, vec2 u) {
    float theta = 0.5 * acos(1.0 - 2.0 * u.y);
    vec3 t = normalize(cross(n, abs(n.x) < 0.5 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0)));
    return cos(theta) * n + sin(theta) * (cos(2.0 * pi * u.x) * t + sin(2.0 * pi * u.x) * cross(n, t));
}
// mistake pi_missing
float cosine_density(vec3 n, vec3 wi) { return max(0.0, dot(n, wi)); }
vec3 cosine_direction(vec3 n, vec2 u) {
    float r = sqrt(u.x), phi = 2.0 * pi * u.y;
    return frame_around(n) * vec3(r * cos(phi), r * sin(phi), sqrt(1.0 - u.x));
}
// mistake over_2_pi
float cosine_density(vec3 n, vec3 wi) { return max(0.0, dot(n, wi)) / (2.0 * pi); }
vec3 cosine_direction(vec3 n, vec2 u) {
    float r = sqrt(u.x), phi = 2.0 * pi * u.y;
    return frame_around(n) * vec3(r * cos(phi), r * sin(phi), sqrt(1.0 - u.x));
}
// mistake uniform_density
float cosine_density(vec3 n, vec3 wi) { return dot(n, wi) > 0.0 ? 0.5 / pi : 0.0; }
vec3 cosine_direction(vec3 n, vec2 u) {
    float r = sqrt(u.x), phi = 2.0 * pi * u.y;
    return frame_around(n) * vec3(r * cos(phi), r * sin(phi), sqrt(1.0 - u.x));
}
// mistake not_clamped
float cosine_density(vec3 n, vec3 wi) { return dot(n, wi) / pi; }
vec3 cosine_direction(vec3 n, vec2 u) {
    float r = sqrt(u.x), phi = 2.0 * pi * u.y;
    return frame_around(n) * vec3(r * cos(phi), r * sin(phi), sqrt(1.0 - u.x));
}
// mistake both_sides
float cosine_density(vec3 n, vec3 wi) { return abs(dot(n, wi)) / pi; }
vec3 cosine_direction(vec3 n, vec2 u) {
    float r = sqrt(u.x), phi = 2.0 * pi * u.y;
    return frame_around(n) * vec3(r * cos(phi), r * sin(phi), sqrt(1.0 - u.x));
}
// mistake uniform_directions
float cosine_density(vec3 n, vec3 wi) { return max(0.0, dot(n, wi)) / pi; }
vec3 cosine_direction(vec3 n, vec2 u) {
    float r = sqrt(1.0 - u.x * u.x), phi = 2.0 * pi * u.y;
    return frame_around(n) * vec3(r * cos(phi), r * sin(phi), u.x);
}
// mistake root_missing
float cosine_density(vec3 n, vec3 wi) { return max(0.0, dot(n, wi)) / pi; }
vec3 cosine_direction(vec3 n, vec2 u) {
    float r = u.x, phi = 2.0 * pi * u.y;
    return frame_around(n) * vec3(r * cos(phi), r * sin(phi), sqrt(1.0 - u.x * u.x));
}
// mistake around_the_z_axis
float cosine_density(vec3 n, vec3 wi) { return max(0.0, dot(n, wi)) / pi; }
vec3 cosine_direction(vec3 n, vec2 u) {
    float r = sqrt(u.x), phi = 2.0 * pi * u.y;
    return vec3(r * cos(phi), r * sin(phi), sqrt(1.0 - u.x));
}
// mistake phi_without_2_pi
float cosine_density(vec3 n, vec3 wi) { return max(0.0, dot(n, wi)) / pi; }
vec3 cosine_direction(vec3 n, vec2 u) {
    float r = sqrt(u.x), phi = u.y;
    return frame_around(n) * vec3(r * cos(phi), r * sin(phi), sqrt(1.0 - u.x));
}
