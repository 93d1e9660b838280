#version 410 core
// How steeply light falls: Σ E cosθ_i in r and Σ E in g, as luminance [lx]; their quotient is the mean cosθ_i.
#include "integrator/incident.glsl"
#include "surface/at_fragment.glsl"

out vec4 film;

void main() {
    Surface x = surface_at_fragment();
    vec2 sums = vec2(0.0);
    for (int k = first_light; !is_unlit && k < end_light; ++k) {
        Incident a = incident_from(k, x);
        sums += luminance(a.E) * vec2(abs(dot(x.n, a.light.wi)), 1.0);
    }
    film = vec4(sums * x.coverage, 0.0, x.coverage);
}
