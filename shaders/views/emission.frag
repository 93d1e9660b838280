#version 410 core
// Emitted radiance of the surface: L_e [cd/m²].
#include "surface/surface.glsl"
#include "integrator/emitted.glsl"
#include "surface/at_fragment.glsl"

out vec4 film;

void main() {
    Surface x = surface_at_fragment();
    film = vec4(emitted(x) * x.coverage, x.coverage);
}
