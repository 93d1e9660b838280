// solution by_the_plane
float distance_to(vec3 x, vec3 w, Triangle triangle) {
    vec3 n = cross(triangle.b - triangle.a, triangle.c - triangle.a);
    float t = dot(triangle.a - x, n) / dot(w, n);
    if (!(t > 0.0) || isinf(t)) return no_hit;
    vec3 y = x + t * w;
    vec3 inside = vec3(dot(cross(triangle.b - triangle.a, y - triangle.a), n), dot(cross(triangle.c - triangle.b, y - triangle.b), n),
                       dot(cross(triangle.a - triangle.c, y - triangle.c), n));
    return all(greaterThanEqual(inside, vec3(0.0))) ? t : no_hit;
}
// solution by_volumes
float distance_to(vec3 x, vec3 w, Triangle triangle) {
    vec3 a = triangle.a - x, b = triangle.b - x, c = triangle.c - x;
    float of_a = dot(w, cross(b, c)), of_b = dot(w, cross(c, a)), of_c = dot(w, cross(a, b));
    bool is_met = (of_a >= 0.0 && of_b >= 0.0 && of_c >= 0.0) || (of_a <= 0.0 && of_b <= 0.0 && of_c <= 0.0);
    float sum = of_a + of_b + of_c;
    if (!is_met || sum == 0.0) return no_hit;
    float t = dot(w, (of_a * a + of_b * b + of_c * c) / sum);
    return t > 0.0 ? t : no_hit;
}
// solution by_a_matrix
float distance_to(vec3 x, vec3 w, Triangle triangle) {
    mat3 m = mat3(triangle.b - triangle.a, triangle.c - triangle.a, -w);
    if (determinant(m) == 0.0) return no_hit;
    vec3 uvt = inverse(m) * (x - triangle.a);
    if (min(uvt.x, uvt.y) < 0.0 || uvt.x + uvt.y > 1.0 || uvt.z <= 0.0) return no_hit;
    return uvt.z;
}
// mistake behind_x_too
float distance_to(vec3 x, vec3 w, Triangle triangle) {
    vec3 e1 = triangle.b - triangle.a, e2 = triangle.c - triangle.a;
    vec3 p = cross(w, e2);
    float determinant = dot(e1, p);
    if (determinant == 0.0) return no_hit;
    vec3 s = x - triangle.a;
    float u = dot(s, p) / determinant;
    vec3 q = cross(s, e1);
    float v = dot(w, q) / determinant;
    float t = dot(e2, q) / determinant;
    return u >= 0.0 && v >= 0.0 && u + v <= 1.0 ? t : no_hit;
}
// mistake parallelogram
float distance_to(vec3 x, vec3 w, Triangle triangle) {
    vec3 e1 = triangle.b - triangle.a, e2 = triangle.c - triangle.a;
    vec3 p = cross(w, e2);
    float determinant = dot(e1, p);
    if (determinant == 0.0) return no_hit;
    vec3 s = x - triangle.a;
    float u = dot(s, p) / determinant;
    vec3 q = cross(s, e1);
    float v = dot(w, q) / determinant;
    float t = dot(e2, q) / determinant;
    return u >= 0.0 && v >= 0.0 && u <= 1.0 && v <= 1.0 && t > 0.0 ? t : no_hit;
}
// mistake whole_plane
float distance_to(vec3 x, vec3 w, Triangle triangle) {
    vec3 e1 = triangle.b - triangle.a, e2 = triangle.c - triangle.a;
    vec3 p = cross(w, e2);
    float determinant = dot(e1, p);
    if (determinant == 0.0) return no_hit;
    vec3 s = x - triangle.a;
    float u = dot(s, p) / determinant;
    vec3 q = cross(s, e1);
    float v = dot(w, q) / determinant;
    float t = dot(e2, q) / determinant;
    return t > 0.0 ? t : no_hit;
}
// mistake one_side
float distance_to(vec3 x, vec3 w, Triangle triangle) {
    vec3 e1 = triangle.b - triangle.a, e2 = triangle.c - triangle.a;
    vec3 p = cross(w, e2);
    float determinant = dot(e1, p);
    if (determinant <= 0.0) return no_hit;
    vec3 s = x - triangle.a;
    float u = dot(s, p) / determinant;
    vec3 q = cross(s, e1);
    float v = dot(w, q) / determinant;
    float t = dot(e2, q) / determinant;
    return u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t > 0.0 ? t : no_hit;
}
// mistake not_divided
float distance_to(vec3 x, vec3 w, Triangle triangle) {
    vec3 e1 = triangle.b - triangle.a, e2 = triangle.c - triangle.a;
    vec3 p = cross(w, e2);
    float determinant = dot(e1, p);
    if (determinant == 0.0) return no_hit;
    vec3 s = x - triangle.a;
    float u = dot(s, p) / determinant;
    vec3 q = cross(s, e1);
    float v = dot(w, q) / determinant;
    float t = dot(e2, q);
    return u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t > 0.0 ? t : no_hit;
}
// mistake edges_not_from_a
float distance_to(vec3 x, vec3 w, Triangle triangle) {
    vec3 e1 = triangle.b - triangle.a, e2 = triangle.c - triangle.b;
    vec3 p = cross(w, e2);
    float determinant = dot(e1, p);
    if (determinant == 0.0) return no_hit;
    vec3 s = x - triangle.a;
    float u = dot(s, p) / determinant;
    vec3 q = cross(s, e1);
    float v = dot(w, q) / determinant;
    float t = dot(e2, q) / determinant;
    return u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t > 0.0 ? t : no_hit;
}
// mistake corners_for_edges
float distance_to(vec3 x, vec3 w, Triangle triangle) {
    vec3 e1 = triangle.b, e2 = triangle.c;
    vec3 p = cross(w, e2);
    float determinant = dot(e1, p);
    if (determinant == 0.0) return no_hit;
    vec3 s = x - triangle.a;
    float u = dot(s, p) / determinant;
    vec3 q = cross(s, e1);
    float v = dot(w, q) / determinant;
    float t = dot(e2, q) / determinant;
    return u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t > 0.0 ? t : no_hit;
}
// mistake one_weight_unchecked
float distance_to(vec3 x, vec3 w, Triangle triangle) {
    vec3 e1 = triangle.b - triangle.a, e2 = triangle.c - triangle.a;
    vec3 p = cross(w, e2);
    float determinant = dot(e1, p);
    if (determinant == 0.0) return no_hit;
    vec3 s = x - triangle.a;
    float u = dot(s, p) / determinant;
    vec3 q = cross(s, e1);
    float v = dot(w, q) / determinant;
    float t = dot(e2, q) / determinant;
    return u >= 0.0 && u + v <= 1.0 && t > 0.0 ? t : no_hit;
}
// mistake squared_distance
float distance_to(vec3 x, vec3 w, Triangle triangle) {
    vec3 e1 = triangle.b - triangle.a, e2 = triangle.c - triangle.a;
    vec3 p = cross(w, e2);
    float determinant = dot(e1, p);
    if (determinant == 0.0) return no_hit;
    vec3 s = x - triangle.a;
    float u = dot(s, p) / determinant;
    vec3 q = cross(s, e1);
    float v = dot(w, q) / determinant;
    float t = dot(e2, q) / determinant;
    return u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t > 0.0 ? t * t : no_hit;
}
// mistake away_from_the_triangle
float distance_to(vec3 x, vec3 w, Triangle triangle) {
    vec3 e1 = triangle.b - triangle.a, e2 = triangle.c - triangle.a;
    vec3 p = cross(w, e2);
    float determinant = dot(e1, p);
    if (determinant == 0.0) return no_hit;
    vec3 s = triangle.a - x;
    float u = dot(s, p) / determinant;
    vec3 q = cross(s, e1);
    float v = dot(w, q) / determinant;
    float t = dot(e2, q) / determinant;
    return u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t > 0.0 ? t : no_hit;
}
