// The integrand of the reflection equation in one direction wi to an emitter, as an estimator adds it:
//
//   w f_r(x, wi, wo) L_i(x, wi) V(x, y) cosθ_i / p
//
// with the density p of the direction, and the weight w of the way by which it was chosen.
#include "surface/surface.glsl"
#include "brdf/brdf.glsl"
#include "integrator/cosine.glsl"
#include "light/light_sample.glsl"
#include "visibility/seen.glsl"

// `k` is the light; `ray` numbers the rays that x sends to it (integrator/rays.glsl).
vec3 weighted_integrand(float w, Surface x, LightSample light, vec3 wo, int k, int ray) {
    float cos_i = cosine(x, light.wi);
    if (!(cos_i > 0.0) || light.Li_over_p == vec3(0.0)) return vec3(0.0);
    return seen(w * f_r(x, light.wi, wo) * light.Li_over_p * cos_i, x, light.wi, light.distance, k, ray);
}
