#version 410 core
// The roughness, 0 to 1, as the material and its texture state it; the GGX width is its square.
#include "surface/at_fragment.glsl"

out vec4 film;

void main() {
    Surface x = surface_at_fragment();
    film = vec4(vec3(x.roughness * x.coverage), x.coverage);
}
