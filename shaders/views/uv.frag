#version 410 core
// The first set of texture coordinates: u in r and v in g, without their whole numbers, so that a seam shows as a jump.
#include "surface/at_fragment.glsl"

out vec4 film;

void main() {
    Surface x = surface_at_fragment();
    film = vec4(vec3(fract(vertex_uv0), 0.0) * x.coverage, x.coverage);
}
