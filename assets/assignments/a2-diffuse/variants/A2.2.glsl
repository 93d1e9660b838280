// solution by_scale_and_offset
float spot_intensity(float intensity, vec3 axis, vec3 w, float cos_inner, float cos_outer) {
    float scale = 1.0 / (cos_inner - cos_outer);
    float s = clamp(dot(axis, w) * scale - cos_outer * scale, 0.0, 1.0);
    return s * s * intensity;
}
float E_spot(vec3 x, vec3 n, vec3 y, float intensity, vec3 axis, float cos_inner, float cos_outer) {
    vec3 to_lamp = normalize(y - x);
    return spot_intensity(1.0, axis, -to_lamp, cos_inner, cos_outer) * E_point(x, n, y, intensity);
}
// solution by_cases
float spot_intensity(float intensity, vec3 axis, vec3 w, float cos_inner, float cos_outer) {
    float c = dot(w, axis);
    if (c <= cos_outer) return 0.0;
    if (c >= cos_inner) return intensity;
    return intensity * pow((cos_outer - c) / (cos_outer - cos_inner), 2.0);
}
float E_spot(vec3 x, vec3 n, vec3 y, float intensity, vec3 axis, float cos_inner, float cos_outer) {
    vec3 d = x - y;
    float r2 = dot(d, d);
    return spot_intensity(intensity, axis, d / sqrt(r2), cos_inner, cos_outer) * max(0.0, -dot(n, d)) / (r2 * sqrt(r2));
}
// mistake not_squared
float spot_intensity(float intensity, vec3 axis, vec3 w, float cos_inner, float cos_outer) {
    float s = (dot(axis, w) - cos_outer) / (cos_inner - cos_outer);
    return intensity * clamp(s, 0.0, 1.0);
}
float E_spot(vec3 x, vec3 n, vec3 y, float intensity, vec3 axis, float cos_inner, float cos_outer) {
    return E_point(x, n, y, spot_intensity(intensity, axis, normalize(x - y), cos_inner, cos_outer));
}
// mistake not_clamped
float spot_intensity(float intensity, vec3 axis, vec3 w, float cos_inner, float cos_outer) {
    float s = (dot(axis, w) - cos_outer) / (cos_inner - cos_outer);
    return intensity * s * s;
}
float E_spot(vec3 x, vec3 n, vec3 y, float intensity, vec3 axis, float cos_inner, float cos_outer) {
    return E_point(x, n, y, spot_intensity(intensity, axis, normalize(x - y), cos_inner, cos_outer));
}
// mistake inner_and_outer_swapped
float spot_intensity(float intensity, vec3 axis, vec3 w, float cos_inner, float cos_outer) {
    float s = clamp((dot(axis, w) - cos_inner) / (cos_outer - cos_inner), 0.0, 1.0);
    return intensity * s * s;
}
float E_spot(vec3 x, vec3 n, vec3 y, float intensity, vec3 axis, float cos_inner, float cos_outer) {
    return E_point(x, n, y, spot_intensity(intensity, axis, normalize(x - y), cos_inner, cos_outer));
}
// mistake smooth_step
float spot_intensity(float intensity, vec3 axis, vec3 w, float cos_inner, float cos_outer) {
    float s = (dot(axis, w) - cos_outer) / (cos_inner - cos_outer);
    return intensity * smoothstep(0.0, 1.0, s);
}
float E_spot(vec3 x, vec3 n, vec3 y, float intensity, vec3 axis, float cos_inner, float cos_outer) {
    return E_point(x, n, y, spot_intensity(intensity, axis, normalize(x - y), cos_inner, cos_outer));
}
// mistake hard_edge
float spot_intensity(float intensity, vec3 axis, vec3 w, float cos_inner, float cos_outer) {
    return dot(axis, w) > cos_outer ? intensity : 0.0;
}
float E_spot(vec3 x, vec3 n, vec3 y, float intensity, vec3 axis, float cos_inner, float cos_outer) {
    return E_point(x, n, y, spot_intensity(intensity, axis, normalize(x - y), cos_inner, cos_outer));
}
// mistake cosine_to_the_lamp
float spot_intensity(float intensity, vec3 axis, vec3 w, float cos_inner, float cos_outer) {
    float s = (dot(axis, w) - cos_outer) / (cos_inner - cos_outer);
    s = clamp(s, 0.0, 1.0);
    return intensity * s * s;
}
float E_spot(vec3 x, vec3 n, vec3 y, float intensity, vec3 axis, float cos_inner, float cos_outer) {
    return E_point(x, n, y, spot_intensity(intensity, axis, normalize(y - x), cos_inner, cos_outer));
}
// mistake direction_reversed
float spot_intensity(float intensity, vec3 axis, vec3 w, float cos_inner, float cos_outer) {
    float s = clamp((dot(axis, -w) - cos_outer) / (cos_inner - cos_outer), 0.0, 1.0);
    return intensity * s * s;
}
float E_spot(vec3 x, vec3 n, vec3 y, float intensity, vec3 axis, float cos_inner, float cos_outer) {
    return E_point(x, n, y, spot_intensity(intensity, axis, normalize(x - y), cos_inner, cos_outer));
}
// mistake angles_for_cosines
float spot_intensity(float intensity, vec3 axis, vec3 w, float cos_inner, float cos_outer) {
    float s = clamp((acos(cos_outer) - acos(clamp(dot(axis, w), -1.0, 1.0))) / (acos(cos_outer) - acos(cos_inner)), 0.0, 1.0);
    return intensity * s * s;
}
float E_spot(vec3 x, vec3 n, vec3 y, float intensity, vec3 axis, float cos_inner, float cos_outer) {
    return E_point(x, n, y, spot_intensity(intensity, axis, normalize(x - y), cos_inner, cos_outer));
}
// mistake not_normalised
float spot_intensity(float intensity, vec3 axis, vec3 w, float cos_inner, float cos_outer) {
    float s = (dot(axis, w) - cos_outer) / (cos_inner - cos_outer);
    s = clamp(s, 0.0, 1.0);
    return intensity * s * s;
}
float E_spot(vec3 x, vec3 n, vec3 y, float intensity, vec3 axis, float cos_inner, float cos_outer) {
    return E_point(x, n, y, spot_intensity(intensity, axis, x - y, cos_inner, cos_outer));
}
// mistake cone_missing
float spot_intensity(float intensity, vec3 axis, vec3 w, float cos_inner, float cos_outer) {
    float s = (dot(axis, w) - cos_outer) / (cos_inner - cos_outer);
    s = clamp(s, 0.0, 1.0);
    return intensity * s * s;
}
float E_spot(vec3 x, vec3 n, vec3 y, float intensity, vec3 axis, float cos_inner, float cos_outer) {
    return E_point(x, n, y, intensity);
}
