#version 410 core
// The metalness of the surface: 0 for a dielectric, 1 for a metal, as the material and its texture state it.
#include "surface/at_fragment.glsl"

out vec4 film;

void main() {
    Surface x = surface_at_fragment();
    film = vec4(vec3(x.metallic * x.coverage), x.coverage);
}
