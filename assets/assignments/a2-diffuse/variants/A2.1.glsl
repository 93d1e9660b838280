// solution by_the_cube
float E_point(vec3 x, vec3 n, vec3 y, float intensity) {
    vec3 d = y - x;
    float r = length(d);
    return intensity * max(dot(n, d), 0.0) / (r * r * r);
}
// solution in_parts
float E_point(vec3 x, vec3 n, vec3 y, float intensity) {
    float r = distance(x, y);
    vec3 wi = normalize(y - x);
    float c = dot(wi, n);
    if (c < 0.0) return 0.0;
    return intensity / r * c / r;
}
// mistake cosine_missing
float E_point(vec3 x, vec3 n, vec3 y, float intensity) {
    vec3 d = y - x;
    float r = length(d);
    return intensity / (r * r);
}
// mistake cosine_not_clamped
float E_point(vec3 x, vec3 n, vec3 y, float intensity) {
    vec3 d = y - x;
    float r = length(d);
    return intensity * dot(n, d / r) / (r * r);
}
// mistake absolute_cosine
float E_point(vec3 x, vec3 n, vec3 y, float intensity) {
    vec3 d = y - x;
    float r = length(d);
    return intensity * abs(dot(n, d / r)) / (r * r);
}
// mistake not_squared
float E_point(vec3 x, vec3 n, vec3 y, float intensity) {
    vec3 d = y - x;
    float r = length(d);
    return intensity * max(0.0, dot(n, d / r)) / r;
}
// mistake distance_missing
float E_point(vec3 x, vec3 n, vec3 y, float intensity) {
    vec3 d = y - x;
    float r = length(d);
    return intensity * max(0.0, dot(n, d / r));
}
// mistake direction_not_normalised
float E_point(vec3 x, vec3 n, vec3 y, float intensity) {
    vec3 d = y - x;
    float r = length(d);
    return intensity * max(0.0, dot(n, d)) / (r * r);
}
// mistake direction_reversed
float E_point(vec3 x, vec3 n, vec3 y, float intensity) {
    vec3 d = y - x;
    float r = length(d);
    return intensity * max(0.0, dot(n, -d / r)) / (r * r);
}
// mistake distance_from_the_origin
float E_point(vec3 x, vec3 n, vec3 y, float intensity) {
    vec3 wi = normalize(y - x);
    return intensity * max(0.0, dot(n, wi)) / dot(y, y);
}
// mistake over_4_pi
float E_point(vec3 x, vec3 n, vec3 y, float intensity) {
    vec3 d = y - x;
    float r = length(d);
    return intensity * max(0.0, dot(n, d / r)) / (4.0 * pi * r * r);
}
// mistake cosine_squared
float E_point(vec3 x, vec3 n, vec3 y, float intensity) {
    vec3 d = y - x;
    float r = length(d);
    float c = max(0.0, dot(n, d / r));
    return intensity * c * c / (r * r);
}
