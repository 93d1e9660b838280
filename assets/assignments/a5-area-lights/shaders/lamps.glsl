// The lamps of the assignment, and what tasks share. Nothing is to be written here.
#include "base/constants.glsl"
#include "base/frame_around.glsl"
#include "parameters.glsl"

// A rectangle. Its edges are at right angles; it shines to the side of edge_u × edge_v.
struct Rectangle {
    vec3 corner; // [m]
    vec3 edge_u; // [m]
    vec3 edge_v; // [m]
};

// A rectangle around a center that shines along the unit vector `axis`. `turn` rotates it in its plane [rad].
Rectangle rectangle_at(vec3 center, vec3 axis, float turn, float height) {
    mat3 world_from_local = frame_around(axis);
    vec3 u = world_from_local * vec3(cos(turn), sin(turn), 0.0) * lamp_width;
    vec3 v = world_from_local * vec3(-sin(turn), cos(turn), 0.0) * height;
    return Rectangle(center - 0.5 * (u + v), u, v);
}

// The lamp of most checks: it hangs around (0, 0, 1) [m] over the origin, tilted by `tilt` and turned by `turn` [rad].
Rectangle lamp(float tilt, float turn) { return rectangle_at(vec3(0.0, 0.0, 1.0), vec3(sin(tilt), 0.0, -cos(tilt)), turn, 0.6); }

// The halves of r along edge_u.
Rectangle first_half(Rectangle r) { return Rectangle(r.corner, 0.5 * r.edge_u, r.edge_v); }
Rectangle second_half(Rectangle r) { return Rectangle(r.corner + 0.5 * r.edge_u, 0.5 * r.edge_u, r.edge_v); }

// Where the point y of r lies on it: (0, 0) at its corner, (1, 1) across.
vec2 place_on(Rectangle r, vec3 y) {
    return vec2(dot(y - r.corner, r.edge_u) / dot(r.edge_u, r.edge_u), dot(y - r.corner, r.edge_v) / dot(r.edge_v, r.edge_v));
}

// Whether a ray from x along w meets the front of r.
bool meets(Rectangle r, vec3 x, vec3 w) {
    vec3 n_y = cross(r.edge_u, r.edge_v);
    float t = dot(r.corner - x, n_y) / dot(w, n_y);
    vec2 place = place_on(r, x + t * w);
    return t > 0.0 && dot(w, n_y) < 0.0 && all(greaterThan(place, vec2(0.0))) && all(lessThan(place, vec2(1.0)));
}

// Whether a ray from x along w meets the sphere of center c and radius R.
bool meets_sphere(vec3 x, vec3 c, float R, vec3 w) { return dot(w, c - x) > 0.0 && length(cross(w, c - x)) < R; }

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
