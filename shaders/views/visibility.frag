#version 410 core
// Irradiance in r and unshadowed irradiance in g, as luminance [lx]; V = r / g.
#include "integrator/incident.glsl"
#include "surface/at_fragment.glsl"

out vec4 film;

void main() {
    Surface x = surface_at_fragment();
    vec2 E = vec2(0.0);
    for (int k = first_light; !is_unlit && k < end_light; ++k) {
        Incident a = incident_from(k, x);
        E += vec2(luminance(a.E), luminance(a.E_unshadowed));
    }
    film = vec4(E * x.coverage, 0.0, x.coverage);
}
