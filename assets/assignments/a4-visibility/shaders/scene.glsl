// The triangles that light may meet, and the lamp. Nothing is to be written here.
#include "base/constants.glsl"
#include "base/frame_around.glsl"
#include "parameters.glsl"

struct Triangle {
    vec3 a;      // its corners [m]
    vec3 b;
    vec3 c;
    vec3 L_e;    // the radiance that its front sends out [cd/m²]; the front is on the side of (b - a) × (c - a)
    float alpha; // the share of its area that is covered
    vec3 tint;   // the share of the light that what covers it lets through, by red, green and blue; 0: opaque
};

// Half of a parallelogram: the triangle of the number `half`, 0 or 1.
Triangle half_of(vec3 corner, vec3 u, vec3 v, int half_number, vec3 L_e, float alpha, vec3 tint) {
    vec3 across = corner + u + v;
    if (half_number == 0) return Triangle(corner, corner + u, across, L_e, alpha, tint);
    return Triangle(corner, across, corner + v, L_e, alpha, tint);
}

// The lamp: 0.8 m × 0.6 m at the height of 2 m. It shines down.
const vec3 lamp_corner = vec3(-0.4, 0.3, 2.0);
const vec3 lamp_u = vec3(0.8, 0.0, 0.0);
const vec3 lamp_v = vec3(0.0, -0.6, 0.0);
const vec3 lamp_L_e = vec3(500.0, 400.0, 300.0);

vec3 point_on_lamp(vec2 u) { return lamp_corner + u.x * lamp_u + u.y * lamp_v; }

// The lower of the two panes of glass, and its normal.
const vec3 pane_corner = vec3(-2.0, -2.0, 0.7);
const vec3 pane_u = vec3(1.4, 0.0, 0.0);
const vec3 pane_v = vec3(0.0, 4.0, 0.1);

vec3 point_on_pane(vec2 u) { return pane_corner + u.x * pane_u + u.y * pane_v; }
vec3 pane_n() { return normalize(cross(pane_u, pane_v)); }

#ifndef RENDERED // the renderer has triangles of its own: see overlay/visibility/visibility.glsl
int triangle_count() { return 12; }

// A lamp, a red sign at its side, two panes of glass, an opaque screen whose edge lies at x = screen_edge, a floor.
Triangle triangle_at(int i) {
    vec3 black = vec3(0.0);
    int k = i / 2, h = i % 2;
    if (k == 0) return half_of(lamp_corner, lamp_u, lamp_v, h, lamp_L_e, 1.0, black);
    if (k == 1) return half_of(vec3(-1.4, 0.4, 1.5), vec3(0.1, -0.8, 0.0), vec3(0.4, 0.0, 0.5), h, vec3(90.0, 5.0, 2.0), 1.0, black);
    if (k == 2) return half_of(pane_corner, pane_u, pane_v, h, black, glass_alpha, vec3(0.9, 0.6, 0.3));
    if (k == 3) return half_of(vec3(-2.0, -2.0, 1.0), vec3(1.3, 0.0, 0.2), vec3(0.7, 4.0, 0.0), h, black, 1.0, vec3(0.4, 0.8, 0.9));
    if (k == 4) return half_of(vec3(screen_edge, -2.0, 1.0), vec3(2.0, 0.0, 0.0), vec3(0.0, 4.0, 0.0), h, black, 1.0, black);
    return half_of(vec3(-3.0, -3.0, 0.0), vec3(6.0, 0.0, 0.0), vec3(0.0, 6.0, 0.0), h, black, 1.0, black);
}
#endif

// The share of the lamp that the screen leaves visible from x, on the floor and right of the panes: the ray to the point
// y of the lamp is at the screen's height halfway.
float seen_share(vec3 x) { return clamp((2.0 * screen_edge - x.x - lamp_corner.x) / lamp_u.x, 0.0, 1.0); }

// A triangle of about two metres around `center`, at right angles to n.
Triangle triangle_around(vec3 center, vec3 n) {
    mat3 f = frame_around(n);
    return Triangle(center + f[0], center - f[0] + f[1], center - f[0] - f[1], vec3(0.0), 1.0, vec3(0.0));
}

// A point of the triangle, with the rounding that a renderer has, too.
vec3 point_of(Triangle t) { return (t.a + t.b + t.c) / 3.0; }

// w, or w mirrored at the plane of n where `side` is below 0.
vec3 on_side(vec3 w, vec3 n, float side) { return side < 0.0 ? w - 2.0 * dot(w, n) * n : w; }

float largest_coordinate(vec3 v) { return max(abs(v.x), max(abs(v.y), abs(v.z))); }

// Numbers in [0, 1)² that look random: pair i of the sequence of `seed`.
vec2 random_2d(float seed, int i) {
    uvec2 v = uvec2(floatBitsToUint(seed), uint(i) * 2654435769u + 1u);
    for (int k = 0; k < 4; ++k) {
        v = v * 1664525u + 1013904223u;
        v += v.yx * 1664525u;
        v ^= v >> 16u;
    }
    return vec2(v >> 8u) / 16777216.0;
}
