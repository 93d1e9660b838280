// The reflection equation for light that comes straight from emitters:
//
//   L_r(x, wo) = Σ_k ∫ f_r(x, wi, wo) L_i(x, wi) V(x, y) cosθ_i dω_i
//
// Each integral by two points a frame, one where the light is and one where the BRDF has its peak, weighed by the
// power heuristic (Veach & Guibas 1995, section 5.2, β = 2); emitters without extent are known exactly and take one.
// Frames add up to the integral. This is the only loop over lights; integrand.glsl has the only cosine.
#include "surface/surface.glsl"
#include "brdf/brdf.glsl"
#include "integrator/integrand.glsl"
#include "integrator/mirrored.glsl"
#include "integrator/power_heuristic.glsl"
#include "integrator/random_point.glsl"
#include "integrator/rays.glsl"
#include "integrator/shadowed.glsl"
#include "light/sample_light.glsl"

vec3 reflected(Surface x, vec3 wo) {
    if (is_mirror) return mirrored(x, wo);
    bool samples_brdf = has_lights_to_meet && has_peak(x);
    vec3 w_brdf = samples_brdf ? sample_f_r(x, wo, random_point(0u)) : vec3(0.0);
    float p_brdf = samples_brdf ? pdf_f_r(x, w_brdf, wo) : 0.0;

    vec3 L_r = vec3(0.0);
    for (int k = first_light; k < end_light; ++k) {
        vec2 u = has_area_lights ? random_point(uint(k) + 1u) : vec2(0.0);
        LightSample from_light = sample_light(k, x.position, u);
        bool shares = samples_brdf && from_light.p > 0.0;
        float weight = shares ? power_heuristic(from_light.p, pdf_f_r(x, from_light.wi, wo)) : 1.0;
        vec3 L = weighted_integrand(weight, x, from_light, wo, k, towards_light);

        LightSample along = no_light;
        if (samples_brdf) along = light_along(k, x.position, w_brdf);
        if (along.p > 0.0 && p_brdf > 0.0) { // the point came with density p_brdf, so that is what the integrand is over
            L += weighted_integrand(power_heuristic_over(p_brdf, along.p), x, along, wo, k, along_brdf);
        }
        L_r += shadowed(L, k, x, wo);
    }
    return L_r;
}
