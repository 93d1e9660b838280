// The reflection equation without noise, for interaction (--estimator analytic puts this file in the place of
// reflected.glsl): every emitter that has an outline by integrator/analytic_lobe.glsl, points, spots and parallel light
// as they are, and meshes of many triangles by samples.
#include "integrator/analytic_lobe.glsl"
#include "integrator/sampled_light.glsl"

vec3 reflected(Surface x, vec3 wo) {
    vec3 L_r = vec3(0.0);
    for (int k = first_light; k < end_light; ++k) {
        Light light = light_at(k);
        int parts = outlines_of(light);
        if (parts == 0) L_r += reflected_from_samples(k, x, wo);
        for (int part = 0; part < parts; ++part) L_r += reflected_from_outline(light, part, parts, x, wo);
    }
    return L_r;
}
