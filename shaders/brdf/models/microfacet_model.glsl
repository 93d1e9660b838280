// The common part of all metals, whatever their Fresnel term F_metal_of(x, cos_h) and its mean F_mean_of(x).
#include "brdf/energy_compensation.glsl"
#include "brdf/lobe_sum.glsl"
#include "brdf/microfacets.glsl"

vec3 F_metal_of(Surface x, float cos_h);
vec3 F_mean_of(Surface x);

Lobes model_lobes(Surface x, vec3 wi, vec3 wo) {
    if (dot(x.n, wi) <= 0.0) return Lobes(vec3(0.0), vec3(0.0));
    vec3 h = half_vector(wi, wo, x.n);
    vec3 back = has_energy_compensation ? f_compensation(x, wi, wo, F_mean_of(x)) : vec3(0.0);
    return Lobes(back, F_metal_of(x, dot(wo, h)) * D_V(x, h, wi, wo));
}

vec3 f_model(Surface x, vec3 wi, vec3 wo) {
    Lobes f = model_lobes(x, wi, wo);
    return f.diffuse + f.specular;
}

bool model_has_peak(Surface x) { return true; }
vec3 sample_model(Surface x, vec3 wo, vec2 u) { return sample_microfacets(x, wo, u); }
float p_model(Surface x, vec3 wi, vec3 wo) { return p_microfacets(x, wi, wo); }

bool model_has_diffuse_lobe(Surface x) { return has_energy_compensation; }
bool model_has_specular_lobe(Surface x) { return true; }
// Between F at normal incidence and 1 as Schlick has it, which is near for any metal.
vec3 model_specular_albedo(Surface x, float DV, float schlick) {
    return F_metal_of(x, 1.0) * (DV - schlick) + vec3(schlick);
}
