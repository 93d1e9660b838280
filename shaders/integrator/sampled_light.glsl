// One light by samples, where the analytic estimator has no outline to go by; as reflected.glsl has it.
#include "brdf/f_r.glsl"
#include "brdf/sample_f_r.glsl"
#include "integrator/cosine.glsl"
#include "integrator/random_point.glsl"
#include "integrator/rays.glsl"
#include "light/sample_light.glsl"
#include "visibility/visibility.glsl"

// Points, spots, parallel light and meshes: none that a direction of the BRDF's choice could meet, so one sample.
vec3 reflected_from_sample(int k, Surface x, vec3 wo) {
    LightSample light = sample_light(k, x.position, random_point(uint(k) + 1u));
    float cos_i = cosine(x, light.wi);
    if (!(cos_i > 0.0) || light.Li_over_p == vec3(0.0)) return vec3(0.0);
    return f_r(x, light.wi, wo) * light.Li_over_p * cos_i * visibility(x, light.wi, light.distance, k, towards_light);
}
