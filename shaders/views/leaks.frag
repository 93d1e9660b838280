#version 410 core
// Light that the shading normal lets in though the triangle itself turns its back on it: E of it in r, what it would be
// without shadows in g, and E of all lights without shadows in b, as luminance [lx]. r / b is what leaks through the surface;
// g / b is what its back would have to keep out: facets show at the edge of its own shadow.
#include "integrator/incident.glsl"
#include "surface/at_fragment.glsl"

out vec4 film;

// The triangle's own normal, on the side of the viewer.
vec3 geometric_normal() {
    vec3 n = normalize(across_triangle());
    return faceforward(n, -direction_to_viewer(), n);
}

void main() {
    Surface x = surface_at_fragment();
    vec3 n_geometric = geometric_normal();
    vec3 E = vec3(0.0);
    for (int k = first_light; !is_unlit && k < end_light; ++k) {
        Incident a = incident_from(k, x);
        float behind = dot(n_geometric, a.light.wi) < 0.0 ? 1.0 : 0.0;
        E += vec3(behind * luminance(a.E), behind * luminance(a.E_unshadowed), luminance(a.E_unshadowed));
    }
    film = vec4(E * x.coverage, x.coverage);
}
