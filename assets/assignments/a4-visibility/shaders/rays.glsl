// A4.2 to A4.4: what a ray meets first, where a shadow ray begins, and what it goes through.
#include "triangle.glsl"
#include "assignment/not_implemented.glsl"

// begin solution A4.2
// The number of the triangle that the ray from x along w meets first; -1 where it meets none
//
// The triangles are triangle_at(0) to triangle_at(triangle_count() - 1). Call distance_to.
int first_met(vec3 x, vec3 w) {
    int first = -1;
    float nearest = 1e30;
    for (int i = 0; i < triangle_count(); ++i) {
        float t = distance_to(x, w, triangle_at(i));
        if (t > 0.0 && t < nearest) {
            nearest = t;
            first = i;
        }
    }
    return first;
}

// L_i(x, w) = L_e(r(x, w), -w): the radiance that arrives at x from the direction w      [cd/m²]
//
// Only the front of a triangle sends light out. Where the ray meets nothing, nothing arrives.
vec3 L_i(vec3 x, vec3 w) {
    int i = first_met(x, w);
    if (i < 0) return vec3(0.0);
    Triangle y = triangle_at(i);
    bool is_front = dot(cross(y.b - y.a, y.c - y.a), w) < 0.0;
    return is_front ? y.L_e : vec3(0.0);
}
// end

// begin solution A4.3
// Where a ray begins that leaves x, a point of a surface, along w                       [m]
//
// x moves off its surface along the unit normal n, to the side of w, by 2^-16 of its largest coordinate (in magnitude).
vec3 shadow_origin(vec3 x, vec3 n, vec3 w) {
    float side = dot(n, w) < 0.0 ? -1.0 : 1.0;
    return x + side * exp2(-16.0) * largest_coordinate(x) * n;
}
// end

// begin solution A4.4
// What a triangle lets through: T = 1 - α + α · tint, by colour                        [1]
vec3 T_of(Triangle triangle) { return 1.0 - triangle.alpha + triangle.alpha * triangle.tint; }

// V(x, y): the product of T over all triangles between x and y, by colour               [1]
//
// x lies on a surface of normal n. The ray begins at shadow_origin and ends 2^-12 of its length before y, so that the
// triangle of y does not count.
vec3 V_between(vec3 x, vec3 n, vec3 y) {
    vec3 origin = shadow_origin(x, n, y - x);
    float d = length(y - origin);
    vec3 w = (y - origin) / d;
    vec3 V = vec3(1.0);
    for (int i = 0; i < triangle_count(); ++i) {
        float t = distance_to(origin, w, triangle_at(i));
        if (t > 0.0 && t < d * (1.0 - exp2(-12.0))) V *= T_of(triangle_at(i));
    }
    return V;
}
// end
