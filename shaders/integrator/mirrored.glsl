// The reflection equation of an ideal mirror, whose f_r is a delta: the light that comes from where it looks.
//
//   L_r(x, wo) = ρ Σ_k L_k(m) V(x, y_k),    m = 2 (n·wo) n - wo
//
// exact for every emitter of some extent. Points, spots and parallel light have none: no direction meets them, and they are not seen.
#include "surface/surface.glsl"
#include "integrator/cosine.glsl"
#include "integrator/rays.glsl"
#include "integrator/shadowed.glsl"
#include "interface/frame.glsl"
#include "light/mesh_along.glsl"
#include "light/sample_light.glsl"
#include "visibility/seen.glsl"

vec3 mirrored(Surface x, vec3 wo) {
    vec3 m = reflect(-wo, x.n);
    vec3 L = vec3(0.0);
    if (!(cosine(x, m) > 0.0)) return L;
    for (int k = first_light; k < end_light; ++k) {
        LightSample light = light_along(k, x.position, m);
        if (has_mesh_lights && light_at(k).kind == mesh_light) light = mesh_along(light_at(k), x.position, m);
        if (!(light.p > 0.0)) continue;
        vec3 L_k = x.base_color * light.Li_over_p * light.p;
        L += shadowed(seen(L_k, x, m, light.distance, k, towards_light), k, x, wo);
    }
    return L;
}
