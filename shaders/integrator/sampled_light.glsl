// One light by samples, where the analytic estimator has no outline to go by; as reflected.glsl has it.
#include "surface/surface.glsl"
#include "brdf/brdf.glsl"
#include "integrator/cosine.glsl"
#include "integrator/integrand.glsl"
#include "integrator/power_heuristic.glsl"
#include "integrator/random_point.glsl"
#include "integrator/rays.glsl"
#include "light/sample_light.glsl"
#include "visibility/seen.glsl"

// Points, spots, parallel light and meshes: none that a direction of the BRDF's choice could meet, so one sample.
vec3 reflected_from_sample(int k, Surface x, vec3 wo) {
    LightSample light = sample_light(k, x.position, random_point(uint(k) + 1u));
    return weighted_integrand(1.0, x, light, wo, k, towards_light);
}

// Lambert under an environment of one radiance is exact, but for shadows: E = π L, and where a normal map bends n away
// from its surface the part of it that this surface leaves. V is that of a direction chosen in proportion to cosθ.
vec3 lambert_under_environment(int k, vec3 L_e, Surface x, vec3 wo) {
    vec3 wi = sample_f_r(x, wo, random_point(uint(k) + 1u));
    if (!(cosine(x, wi) > 0.0)) return vec3(0.0);
    return seen(f_r(x, x.n, wo) * pi * L_e, x, wi, infinitely_far, k, towards_light);
}

// An environment: by two samples, as reflected.glsl has it.
vec3 reflected_from_environment(int k, Light light, Surface x, vec3 wo) {
    if (is_lambert && !has_picture(light)) return lambert_under_environment(k, light.quantity, x, wo);
    LightSample from_light = sample_light(k, x.position, random_point(uint(k) + 1u));
    float weight = has_peak(x) ? power_heuristic(from_light.p, pdf_f_r(x, from_light.wi, wo)) : 1.0;
    vec3 L = weighted_integrand(weight, x, from_light, wo, k, towards_light);
    if (!has_peak(x)) return L;
    vec3 w_brdf = sample_f_r(x, wo, random_point(0u));
    LightSample along = environment_along(light, w_brdf);
    float weight_along = power_heuristic_over(pdf_f_r(x, w_brdf, wo), along.p);
    return L + weighted_integrand(weight_along, x, along, wo, k, along_brdf);
}
