#version 410 core
// The base colour: the diffuse albedo ρ of a dielectric, F0 of a metal. Linear.
#include "surface/at_fragment.glsl"

out vec4 film;

void main() {
    Surface x = surface_at_fragment();
    film = vec4(x.base_color * x.coverage, x.coverage);
}
