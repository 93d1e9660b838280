// Compensation for the energy that single-scattering GGX loses between its microfacets (--energy-compensation;
// without it rough metals are too dark).
//
//   f = F_ms (1 - E(cos_i)) (1 - E(cos_o)) / (π (1 - E_avg)),     F_ms = F_avg² E_avg / (1 - F_avg (1 - E_avg))
//
// Kulla & Conty 2017, "Revisiting physically based shading at Imageworks", slides 16 to 20. E: the albedo of the lobe without
// its Fresnel term; F_avg = F0 + (1 - F0)/21 for Schlick's. Limit: the table is isotropic, so other lobes take √(α_t α_b).
#include "base/constants.glsl"
#include "brdf/albedo_table.glsl"
#include "interface/features.glsl"
#include "surface/surface.glsl"

float compensated_alpha(Surface x) { return has_anisotropy ? sqrt(x.alphas.x * x.alphas.y) : x.alpha; }

vec3 f_compensation(Surface x, vec3 wi, vec3 wo, vec3 F_avg) {
    float alpha = compensated_alpha(x);
    float loss = mean_loss_ggx(alpha);
    if (loss <= 0.0) return vec3(0.0); // smooth: nothing is blocked
    float lost_i = 1.0 - E_ggx(max(dot(x.n, wi), 0.0), alpha);
    float lost_o = 1.0 - E_ggx(max(dot(x.n, wo), 0.0), alpha);
    vec3 F_ms = F_avg * F_avg * (1.0 - loss) / (1.0 - F_avg * loss);
    return F_ms * lost_i * lost_o / (pi * loss);
}

vec3 mean_schlick(vec3 F0) { return F0 + (1.0 - F0) / 21.0; } // 2 ∫ F cosθ dcosθ
