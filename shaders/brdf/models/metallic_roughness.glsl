// glTF's own material with all of its layers. Two lobes have peaks, the base's and the coat's; they are sampled in
// proportion to what they reflect.
#include "brdf/layers.glsl"
#include "brdf/metallic_roughness.glsl"

vec3 f_r(Surface x, vec3 wi, vec3 wo) { return layered(x, f_metallic_roughness(x, wi, wo), wi, wo); }

bool base_has_peak(Surface x) { return x.metallic > 0.0 || x.specular > 0.0; }
bool has_peak(Surface x) { return base_has_peak(x) || has_clearcoat; }

// Probability of sampling the coat rather than the base. Each gets at least a tenth, since the weights are estimates.
float coat_share(Surface x, vec3 wo) {
    if (!has_clearcoat || x.clearcoat <= 0.0) return 0.0;
    if (!base_has_peak(x)) return 1.0;
    float coat = coat_weight(x, wo);
    float cos_o = max(dot(x.n, wo), 0.0);
    vec3 F = mix(x.specular * F_schlick(x.F0_dielectric, cos_o), F_schlick(x.base_color, cos_o), x.metallic);
    return clamp(coat / (coat + (1.0 - coat) * largest(F)), 0.1, 0.9);
}

vec3 sample_f_r(Surface x, vec3 wo, vec2 u) {
    float share = coat_share(x, wo);
    if (u.x < share) return sample_ggx(x.clearcoat_n, wo, x.clearcoat_alpha, vec2(u.x / share, u.y));
    return sample_microfacets(x, wo, vec2((u.x - share) / (1.0 - share), u.y));
}

float pdf_f_r(Surface x, vec3 wi, vec3 wo) {
    if (has_diffuse_transmission && dot(x.n, wi) <= 0.0) return 0.0; // below, light samples answer for all
    float share = coat_share(x, wo);
    float p = (1.0 - share) * p_microfacets(x, wi, wo);
    return share > 0.0 ? p + share * p_ggx(x.clearcoat_n, wi, wo, x.clearcoat_alpha) : p;
}

float peak_alpha(Surface x) { return x.alpha; }

Lobes lobes(Surface x, vec3 wi, vec3 wo) { return metallic_roughness_lobes(x, wi, wo); }
bool has_diffuse_lobe(Surface x) {
    return has_energy_compensation || (x.metallic < 1.0 && x.base_color != vec3(0.0));
}
bool has_specular_lobe(Surface x) { return base_has_peak(x); }

vec3 specular_albedo(Surface x, float DV, float schlick) {
    vec3 F0 = mix(x.specular * x.F0_dielectric, x.base_color, x.metallic);
    float F90 = mix(x.specular, 1.0, x.metallic);
    return F0 * (DV - schlick) + F90 * schlick;
}
