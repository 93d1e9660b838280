#version 410 core
// How large the lights at work are, seen from x, and how much of their light gets through: Ω [sr] in r, E in g and E without
// shadows in b, as luminance; V = g / b.
#include "integrator/incident.glsl"
#include "surface/at_fragment.glsl"

out vec4 film;

void main() {
    Surface x = surface_at_fragment();
    film = vec4(0.0, 0.0, 0.0, 1.0);
    for (int k = first_light; k < end_light; ++k) {
        Incident a = incident_from(k, x);
        film.rgb += vec3(solid_angle_of(k, a.light), luminance(a.E), luminance(a.E_unshadowed));
    }
}
