// The renderer's L_r: the student's directions and weights, over the lamps of the renderer.
// The plates have the model `phong`: their f_r is f_lobe times a colour, their exponent the model's first parameter.
#include "assignment/not_implemented.glsl"
#include "brdf/f_r.glsl"
#include "estimators.glsl"
#include "integrator/random_point.glsl"
#include "integrator/rays.glsl"
#include "interface/material.glsl"
#include "light/sample_light.glsl"
#include "surface/surface.glsl"
#include "visibility/visibility.glsl"

// f_r L_i cosθ_i V, with the L_i/p that the lamp's sample has, times p
vec3 integrand(Surface x, LightSample light, vec3 wo, int k, int ray) {
    float cos_i = dot(x.n, light.wi);
    if (!(cos_i > 0.0) || !(light.p > 0.0)) return vec3(0.0);
    vec3 L_i = light.Li_over_p * light.p * visibility(x, light.wi, light.distance, k, ray);
    return f_r(x, light.wi, wo) * L_i * cos_i;
}

vec3 reflected(Surface x, vec3 wo) {
    float m = model_parameters[0].x;
    vec3 wi = lobe_direction(x.n, wo, m, random_point(0u));
    float p = lobe_density(x.n, wi, wo, m);
    vec3 L_r = vec3(0.0);
    for (int k = first_light; k < end_light; ++k) {
        LightSample a = sample_light(k, x.position, random_point(uint(k) + 1u));
        if (a.p > 0.0)
            L_r += weight(a.p, lobe_density(x.n, a.wi, wo, m)) * integrand(x, a, wo, k, towards_light) / a.p;
        LightSample b = light_along(k, x.position, wi);
        if (b.p > 0.0 && p > 0.0) L_r += weight(p, b.p) * integrand(x, b, wo, k, along_brdf) / p;
    }
    if (not_implemented_calls > 0) return vec3(100.0, 0.0, 100.0); // magenta [cd/m²]
    return L_r;
}
