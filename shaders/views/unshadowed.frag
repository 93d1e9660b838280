#version 410 core
// Unshadowed irradiance from the enabled lights [lx]: irradiance.frag without its V.
#include "integrator/incident.glsl"
#include "surface/at_fragment.glsl"

out vec4 film;

void main() {
    Surface x = surface_at_fragment();
    vec3 E = vec3(0.0);
    for (int k = first_light; !is_unlit && k < end_light; ++k) E += incident_from(k, x).E_unshadowed;
    film = vec4(E * x.coverage, x.coverage);
}
