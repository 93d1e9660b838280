// A4.1: a ray and a triangle.
#include "scene.glsl"
#include "assignment/not_implemented.glsl"

const float no_hit = -1.0;

// begin solution A4.1
// The distance t > 0 at which the ray x + t w meets the triangle; no_hit where it does not     [m]
//
// w is unit. Both sides of the triangle count. What lies behind x does not.
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
    return u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t > 0.0 ? t : no_hit;
}
// end
