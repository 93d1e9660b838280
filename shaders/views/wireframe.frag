#version 410 core
// The edges of the triangles, 1.5 pixels wide: 1 on an edge, 0 away from it, and a slope of a pixel between.
// Where edges would cover most of a triangle they are fainter, so that a dense mesh is grey and not white.
#include "interface/mesh.glsl"
#include "surface/at_fragment.glsl"

out vec4 film;

const float half_width = 0.75; // [pixels]
const float faintest = 0.2;    // edges of a triangle that they cover

vec3 corner(int i) { return corner_position(vertex_of(gl_PrimitiveID, i)); }

// Each is 1 at its corner, and 0 on the edge between the two others.
vec3 barycentric(vec3 p) {
    vec3 a = corner(0);
    vec3 ab = corner(1) - a, ac = corner(2) - a, n = cross(ab, ac);
    float v = dot(cross(p - a, ac), n) / dot(n, n);
    float w = dot(cross(ab, p - a), n) / dot(n, n);
    return vec3(1.0 - v - w, v, w);
}

void main() {
    vec3 b = barycentric(vertex_position); // before any discard, which would end the derivatives
    vec3 slope = sqrt(dFdx(b) * dFdx(b) + dFdy(b) * dFdy(b)); // a pixel
    vec3 pixels = b / max(slope, vec3(1e-20));
    float distance_to_edge = min(pixels.x, min(pixels.y, pixels.z));
    float edge = is_line || is_point ? 1.0 : clamp(half_width + 0.5 - distance_to_edge, 0.0, 1.0);
    // An edge covers half_width over the triangle's height above it, a share of the area for each of three.
    // The slope of a barycentric coordinate is one over that height.
    float covered = 2.0 * half_width * (slope.x + slope.y + slope.z);
    if (!is_line && !is_point) edge *= mix(1.0, faintest, smoothstep(0.4, 1.2, covered));
    Surface x = surface_at_fragment();
    film = vec4(vec3(edge) * x.coverage, x.coverage);
}
