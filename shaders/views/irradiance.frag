#version 410 core
// What arrives from the lights at work, by the points on them alone:
//
//   E(x) = Σ_k ∫ L_i V cosθ_i dω_i          [lx]
#include "integrator/arriving.glsl"
#include "surface/at_fragment.glsl"

out vec4 film;

void main() {
    Surface x = surface_at_fragment();
    vec3 E = vec3(0.0);
    for (int k = first_light; !is_unlit && k < end_light; ++k) E += arriving_from(k, x).E;
    film = vec4(E * x.coverage, x.coverage);
}
