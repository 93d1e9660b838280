// GGX microfacets of a metal by its complex index of refraction. The base colour tints it, as a lacquer would.
#include "brdf/conductor.glsl"
#include "brdf/models/microfacet_model.glsl"

float roughness_across() { return model_parameters[0].x; }
vec3 ior() { return model_parameters[1].rgb; }        // n by channel
vec3 extinction() { return model_parameters[2].rgb; } // k by channel

vec3 F_metal_of(Surface x, float cos_h) { return x.base_color * F_conductor(ior(), extinction(), cos_h); }

// 2 ∫ F cosθ dcosθ by three points of Gauss and Legendre.
vec3 F_mean_of(Surface x) {
    const vec3 at = vec3(0.1127017, 0.5, 0.8872983);
    const vec3 weight = vec3(5.0, 8.0, 5.0) / 18.0;
    vec3 sum = vec3(0.0);
    for (int i = 0; i < 3; ++i) sum += 2.0 * weight[i] * at[i] * F_metal_of(x, at[i]);
    return sum;
}
