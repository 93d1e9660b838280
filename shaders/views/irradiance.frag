#version 410 core
// Irradiance from the enabled lights, by light samples alone:
//
//   E(x) = Σ_k ∫ L_i V cosθ_i dω_i          [lx]
#include "integrator/incident.glsl"
#include "surface/at_fragment.glsl"

out vec4 film;

void main() {
    Surface x = surface_at_fragment();
    vec3 E = vec3(0.0);
    for (int k = first_light; !is_unlit && k < end_light; ++k) E += incident_from(k, x).E;
    film = vec4(E * x.coverage, x.coverage);
}
