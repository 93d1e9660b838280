// A measured BRDF, tinted by the base colour. Half of the directions are distributed as a GGX lobe that falls off
// as the measured one does, half as the cosine.
#include "brdf/cosine_sampling.glsl"
#include "brdf/ggx_sampling.glsl"
#include "brdf/merl.glsl"
#include "brdf/models/no_lobes.glsl"
#include "interface/material.glsl"

float measured_alpha() { return model_parameters[0].x; } // of the GGX lobe that falls off as the measured one does

vec3 f_r(Surface x, vec3 wi, vec3 wo) {
    if (dot(x.n, wi) <= 0.0) return vec3(0.0);
    return x.base_color * f_merl(x.n, wi, wo);
}

bool has_peak(Surface x) { return true; }

vec3 sample_f_r(Surface x, vec3 wo, vec2 u) {
    if (u.x < 0.5) return sample_cosine(x.n, vec2(2.0 * u.x, u.y));
    return sample_ggx(x.n, wo, measured_alpha(), vec2(2.0 * u.x - 1.0, u.y));
}

float pdf_f_r(Surface x, vec3 wi, vec3 wo) {
    return 0.5 * (p_cosine(x.n, wi) + p_ggx(x.n, wi, wo, measured_alpha()));
}

float peak_alpha(Surface x) { return measured_alpha(); }
