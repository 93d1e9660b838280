#version 410 core
// Position of the surface: x [m].
#include "surface/at_fragment.glsl"

out vec4 film;

void main() {
    Surface x = surface_at_fragment();
    film = vec4(x.position * x.coverage, x.coverage);
}
