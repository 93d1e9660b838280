// One light by samples: where the analytic estimator has no outline to go by. As reflected.glsl has it.
#include "base/sampling.glsl"
#include "brdf/f_r.glsl"
#include "brdf/sample_f_r.glsl"
#include "interface/frame.glsl"
#include "light/sample_light.glsl"
#include "visibility/visibility.glsl"

vec2 random_point(uint purpose) {
    uvec2 pixel = uvec2(gl_FragCoord.xy);
    return sobol_2d(sample_index, hash(pixel.x, hash(pixel.y, hash(purpose, seed))));
}

// f_r · L_i/p · V · cosθ_i
vec3 integrand_over_p(Surface x, LightSample light, vec3 wo) {
    float cos_i = dot(x.n, light.wi);
    if (cos_i <= 0.0 || light.Li_over_p == vec3(0.0)) return vec3(0.0);
    float V = visibility(x.position, light.wi, light.distance);
    return f_r(x, light.wi, wo) * light.Li_over_p * V * cos_i;
}

float power_heuristic(float p, float q) { return p * p / (p * p + q * q); }

vec3 reflected_from_samples(int k, Surface x, vec3 wo) {
    LightSample from_light = sample_light(k, x.position, random_point(uint(k) + 1u));
    if (from_light.p <= 0.0 || !has_peak(x)) return integrand_over_p(x, from_light, wo);
    vec3 L_r = power_heuristic(from_light.p, p_f_r(x, from_light.wi, wo)) * integrand_over_p(x, from_light, wo);
    vec3 w_brdf = sample_f_r(x, wo, random_point(0u));
    float p_brdf = p_f_r(x, w_brdf, wo);
    LightSample along = light_along(k, x.position, w_brdf);
    if (along.p > 0.0)
        L_r += power_heuristic(p_brdf, along.p) * along.p / p_brdf * integrand_over_p(x, along, wo);
    return L_r;
}
