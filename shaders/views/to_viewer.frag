#version 410 core
// The direction in which the surface is seen: wo, unit.
#include "surface/at_fragment.glsl"

out vec4 film;

void main() {
    Surface x = surface_at_fragment();
    film = vec4(direction_to_viewer() * x.coverage, x.coverage);
}
