// The reflection equation for light that comes straight from emitters:
//
//   L_r(x, wo) = Σ_k f_r(x, wi, wo) · L_i(x, wi) / p(wi) · V(x, y) · cosθ_i
//
// one point a light and frame; frames add up to the integral (Kajiya 1986; light sampling: Shirley et al. 1996).
// This is the only loop over lights and the only cosine.
#include "base/sampling.glsl"
#include "brdf/f_r.glsl"
#include "interface/frame.glsl"
#include "light/sample_light.glsl"
#include "visibility/visibility.glsl"

// A sequence of its own for every pixel and light, so that neither is correlated with another.
vec2 light_point(int k) {
    if (!has_rectangle_lights) return vec2(0.0);
    uvec2 pixel = uvec2(gl_FragCoord.xy);
    return sobol_2d(sample_index, hash(pixel.x, hash(pixel.y, hash(uint(k), seed))));
}

vec3 reflected(Surface x, vec3 wo) {
    vec3 L_r = vec3(0.0);
    for (int k = 0; k < light_count; ++k) {
        LightSample light = sample_light(k, x.position, light_point(k));
        float cos_i = dot(x.n, light.wi);
        if (cos_i <= 0.0) continue;
        float V = visibility(x.position, light.wi, light.distance);
        L_r += f_r(x, light.wi, wo) * light.Li_over_p * V * cos_i;
    }
    return L_r;
}
