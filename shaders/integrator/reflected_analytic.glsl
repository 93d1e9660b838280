// The reflection equation without noise, for interaction (--estimator analytic puts this file in the place of
// reflected.glsl): every emitter that has an outline by integrator/analytic_lobe.glsl, points, spots and parallel light
// as they are, meshes of many triangles and environments by samples (integrator/sampled_light.glsl).
#include "integrator/analytic_shadow.glsl"
#include "integrator/sampled_light.glsl"
#include "integrator/shadowed.glsl"
#include "visibility/seen.glsl"

// The whole of a light that is evaluated by its outlines, times V in one direction: in the mean over frames the ratio
// of shadowed to unshadowed light (Heitz, Hill & McGuire 2018), so that only penumbrae are noisy.
vec3 reflected_from_outlines(int k, Light light, int parts, Surface x, vec3 wo) {
    vec4 sum = vec4(0.0);
    for (int part = 0; part < parts; ++part) sum += reflected_from_outline(light, part, parts, x, wo);
    vec3 L_r = sum.rgb;
    float amount = sum.a;
    if (!(amount > 0.0)) return L_r;
    vec2 u = random_point(uint(k) + 1u);
    Chosen chosen = Chosen(x.n, 0, u.x * amount, u.y, false);
    for (int part = 0; part < parts; ++part) {
        for (int i = 0; i < 2; ++i)
            if (has_lobe(x, i == 1))
                choose_in_outline(warped_lobe(x, wo, i == 1), light, part, parts, x, wo, chosen);
    }
    vec3 wi = normalize(chosen.wi);
    return seen(L_r, x, wi, distance_along(k, light, chosen.part, x.position, wi), k, towards_light);
}

vec3 reflected_from_light(int k, Light light, Surface x, vec3 wo) {
    if (has_environment_lights && light.kind == environment_light) return reflected_from_environment(k, light, x, wo);
    int parts = outlines_of(light);
    return parts == 0 ? reflected_from_sample(k, x, wo) : reflected_from_outlines(k, light, parts, x, wo);
}

vec3 reflected(Surface x, vec3 wo) {
    vec3 L_r = vec3(0.0);
    for (int k = first_light; k < end_light; ++k) {
        vec3 L = reflected_from_light(k, light_at(k), x, wo);
        L_r += shadowed(L, k, x, wo);
    }
    return L_r;
}
