// A5.1 to A5.4: a rectangle, sampled over its area and over its solid angle.
#include "lamps.glsl"
#include "assignment/not_implemented.glsl"

// begin solution A5.1
// A point of r, uniform over the area, from u in [0, 1)²                                [m]
vec3 point_on(Rectangle r, vec2 u) { return r.corner + u.x * r.edge_u + u.y * r.edge_v; }

// Its density over the area: p_A = 1/A                                                  [1/m²]
float p_area(Rectangle r) { return 1.0 / (length(r.edge_u) * length(r.edge_v)); }
// end

// begin solution A5.2
// p(wi) = p_A d² / cosθ_y                                                               [1/sr]
//
// d is the distance from x to the point y of r; θ_y is the angle at y between the normal of r and the direction
// to x. Behind the lamp, where cosθ_y ≤ 0, the density is 0. Call p_area.
float p_direction(Rectangle r, vec3 x, vec3 y) {
    vec3 to_x = x - y;
    float d2 = dot(to_x, to_x);
    float cos_y = dot(normalize(cross(r.edge_u, r.edge_v)), to_x / sqrt(d2));
    return cos_y > 0.0 ? p_area(r) * d2 / cos_y : 0.0;
}
// end

// begin solution A5.3
// Ω, the solid angle of r seen from x                                                   [sr]
//
// x lies before the lamp. For a triangle of unit directions a, b, c:
// tan(Ω/2) = |a · (b × c)| / (1 + a·b + b·c + c·a)
float solid_angle(Rectangle r, vec3 x) {
    vec3 a = normalize(r.corner - x);
    vec3 b = normalize(r.corner + r.edge_u - x);
    vec3 c = normalize(r.corner + r.edge_u + r.edge_v - x);
    vec3 d = normalize(r.corner + r.edge_v - x);
    float abc = 2.0 * atan(abs(dot(a, cross(b, c))), 1.0 + dot(a, b) + dot(b, c) + dot(c, a));
    float acd = 2.0 * atan(abs(dot(a, cross(c, d))), 1.0 + dot(a, c) + dot(c, d) + dot(d, a));
    return abc + acd;
}
// end

// begin solution A5.4
float corner_angle(float z, float s, float t) { return atan(-z * sqrt(s * s + t * t + z * z), s * t); }

// A direction from x to r, uniform over the solid angle, from u in [0, 1)²              [1]
//
// Its density is 1/Ω. x lies before the lamp. The handout has the steps; call solid_angle if you like.
vec3 direction_to(Rectangle r, vec3 x, vec2 u) {
    vec3 ex = normalize(r.edge_u), ey = normalize(r.edge_v), ez = cross(ex, ey);
    vec3 corner = r.corner - x;
    float z = dot(corner, ez);
    if (z > 0.0) {
        ez = -ez;
        z = -z;
    }
    vec2 low = vec2(dot(corner, ex), dot(corner, ey));
    vec2 high = low + vec2(length(r.edge_u), length(r.edge_v));
    float b0 = -low.y / sqrt(z * z + low.y * low.y);
    float b1 = high.y / sqrt(z * z + high.y * high.y);
    float turn = u.x * solid_angle(r, x) + 2.0 * pi - corner_angle(z, low.x, high.y) - corner_angle(z, -low.x, low.y);
    float f = (cos(turn) * b0 - b1) / sin(turn);
    float cu = clamp((f > 0.0 ? 1.0 : -1.0) / sqrt(f * f + b0 * b0), -1.0, 1.0);
    float s = clamp(-cu * z / sqrt(max(1.0 - cu * cu, 1e-12)), low.x, high.x);
    float d2 = s * s + z * z;
    float h = mix(low.y / sqrt(d2 + low.y * low.y), high.y / sqrt(d2 + high.y * high.y), u.y);
    float t = h * sqrt(d2 / max(1.0 - h * h, 1e-12));
    return normalize(s * ex + t * ey + z * ez);
}
// end
