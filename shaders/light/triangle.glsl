// Spherical triangles: the directions of a flat triangle, all equally likely.
//
//   tan(Ω/2) = a·(b×c) / (|a||b||c| + (a·b)|c| + (b·c)|a| + (c·a)|b|)          van Oosterom & Strackee 1983, Eq. 8
//
// Sampling as Arvo 1995: c' on the arc from a to c cuts off the share u.x of Ω, then a point on the arc from b to c' such
// that 1 - cos to b is uniform. Where Arvo solves for cosines, the formula above, set equal to tan(u.x Ω/2) with
// c' = a cosθ + t sinθ, gives tan(θ/2) = k (1 + a·b) / (t·(a×b) - k b·t), which stays exact for small triangles.
#include "base/constants.glsl"

// Ω of the triangle with corners a, b, c, told from x; normal = (b - a) × (c - a). Positive, whichever side x is on.
float triangle_solid_angle(vec3 a, vec3 b, vec3 c, vec3 normal) {
    float la = length(a);
    float lb = length(b);
    float lc = length(c);
    float volume = abs(dot(a, normal)); // a·(b×c) without its cancellation
    return 2.0 * atan(volume, la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
}

// A unit direction; the corners need not be unit vectors.
vec3 sample_spherical_triangle(vec3 corner_a, vec3 corner_b, vec3 corner_c, float solid_angle, vec2 u) {
    vec3 a = normalize(corner_a);
    vec3 b = normalize(corner_b);
    vec3 c = normalize(corner_c);
    vec3 from_a = c - a;
    vec3 t = normalize(from_a - dot(a, from_a) * a);
    float k = tan(0.5 * u.x * solid_angle);
    float volume = abs(dot(t, cross(a, b - a)));
    float h = k * (1.0 + dot(a, b)) / (volume - k * dot(b, t)); // tan(θ/2)
    vec3 c_cut = (1.0 - h * h) / (1.0 + h * h) * a + 2.0 * h / (1.0 + h * h) * t;
    vec3 chord = c_cut - b;
    float height = u.y * 0.5 * dot(chord, chord); // 1 - cos of the angle to b
    vec3 across = chord - dot(b, chord) * b;
    float l2 = dot(across, across);
    if (!(l2 > 0.0)) return b;
    return normalize((1.0 - height) * b + sqrt(height * (2.0 - height)) * across * inversesqrt(l2));
}
