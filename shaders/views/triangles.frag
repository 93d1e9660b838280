#version 410 core
// A colour for each triangle of each object, so that the mesh shows. The colours mean nothing else.
#include "base/sampling.glsl"
#include "surface/at_fragment.glsl"

out vec4 film;

void main() {
    Surface x = surface_at_fragment();
    uint code = hash(uint(gl_PrimitiveID), uint(object));
    vec3 color = vec3(code & 255u, code >> 8 & 255u, code >> 16 & 255u) / 255.0;
    film = vec4(color * x.coverage, x.coverage);
}
