// The common part of all metals, whatever their Fresnel term F_metal_of(x, cos_h), its mean F_mean_of(x), and their roughness
// across the tangent.
#include "brdf/energy_compensation.glsl"
#include "brdf/lobe_sum.glsl"
#include "brdf/microfacets.glsl"
#include "interface/material.glsl"

vec3 F_metal_of(Surface x, float cos_h);
vec3 F_mean_of(Surface x);
float roughness_across();

// The surface with the metal's two widths.
Surface with_widths(Surface x) {
    if (has_anisotropy) x.alphas = vec2(x.alpha, alpha_of(roughness_across()));
    return x;
}

Lobes lobes(Surface x, vec3 wi, vec3 wo) {
    if (dot(x.n, wi) <= 0.0) return Lobes(vec3(0.0), vec3(0.0));
    x = with_widths(x);
    vec3 h = half_vector(wi, wo, x.n);
    vec3 back = has_energy_compensation ? f_compensation(x, wi, wo, F_mean_of(x)) : vec3(0.0);
    return Lobes(back, F_metal_of(x, dot(wo, h)) * D_V(x, h, wi, wo));
}

vec3 f_r(Surface x, vec3 wi, vec3 wo) {
    Lobes f = lobes(x, wi, wo);
    return f.diffuse + f.specular;
}

bool has_peak(Surface x) { return true; }
vec3 sample_f_r(Surface x, vec3 wo, vec2 u) { return sample_microfacets(with_widths(x), wo, u); }
float pdf_f_r(Surface x, vec3 wi, vec3 wo) { return p_microfacets(with_widths(x), wi, wo); }
float peak_alpha(Surface x) { return x.alpha; }

bool has_diffuse_lobe(Surface x) { return has_energy_compensation; }
bool has_specular_lobe(Surface x) { return true; }
// Between F at normal incidence and 1 as Schlick has it, which is near for any metal.
vec3 specular_albedo(Surface x, float DV, float schlick) {
    return F_metal_of(x, 1.0) * (DV - schlick) + vec3(schlick);
}
