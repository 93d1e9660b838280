#version 410 core
// The shading normal n, unit, on the side of the viewer; between -1 and 1.
#include "surface/at_fragment.glsl"

out vec4 film;

void main() {
    Surface x = surface_at_fragment();
    film = vec4(x.n * x.coverage, x.coverage);
}
