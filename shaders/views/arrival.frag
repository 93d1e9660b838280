#version 410 core
// From where it arrives: Σ E w_i in rgb and Σ E in a, E as luminance. Their quotient is the mean direction.
#include "integrator/incident.glsl"
#include "surface/at_fragment.glsl"

out vec4 film;

void main() {
    Surface x = surface_at_fragment();
    film = vec4(0.0);
    for (int k = first_light; k < end_light; ++k) {
        Incident a = incident_from(k, x);
        film += luminance(a.E) * vec4(a.light.wi, 1.0);
    }
}
