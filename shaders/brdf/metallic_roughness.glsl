// The material of glTF 2.0: a metal and a coated diffuse dielectric that share one GGX lobe.
//
//   f_r        = mix(dielectric, metal, metallic)
//   metal      = F(base colour) D V
//   dielectric = (1 - s max F(F0)) (1 - t) (1 - δ) ρ/π + s F(F0) D V
//
// glTF 2.0 specification, Appendix B.2 and B.3; s, F0 and the maximum: KHR_materials_specular and KHR_materials_ior. D V:
// KHR_materials_anisotropy, F: KHR_materials_iridescence, where a material has them. t: what KHR_materials_transmission lets
// straight through (surface/glass.glsl); δ: what goes to the other side (diffuse_transmission.glsl). For materials that are half metal the
// appendix's closing simplification (B.3.5) weighs the diffuse part with the blended F instead; the definition above is
// used. Without --energy-compensation, rough metals lose the light that scatters more than once.
#include "base/unit.glsl"
#include "brdf/diffuse_transmission.glsl"
#include "brdf/energy_compensation.glsl"
#include "brdf/fresnel.glsl"
#include "brdf/iridescence.glsl"
#include "brdf/lambert.glsl"
#include "brdf/lobe_sum.glsl"
#include "brdf/microfacets.glsl"

vec3 F_of(Surface x, vec3 F0, float cos_h) {
    vec3 F = F_schlick(F0, cos_h);
    if (!has_iridescence) return F;
    return mix(F, F_thin_film(F0, x.film_ior, x.film_thickness, cos_h), x.iridescence);
}

Lobes metallic_roughness_lobes(Surface x, vec3 wi, vec3 wo) {
    float cos_i = dot(x.n, wi);
    if (has_diffuse_transmission && cos_i < 0.0) {
        vec3 F_below = x.specular * F_of(x, x.F0_dielectric, dot(wo, half_vector(reflect(wi, x.n), wo, x.n)));
        return Lobes((1.0 - largest(F_below)) * f_transmitted(x), vec3(0.0));
    }
    if (cos_i <= 0.0) return Lobes(vec3(0.0), vec3(0.0));

    vec3 h = half_vector(wi, wo, x.n);
    float cos_h = dot(wo, h);
    vec3 F = x.specular * F_of(x, x.F0_dielectric, cos_h);
    vec3 F_metal = F_of(x, x.base_color, cos_h);
    Lobes f = Lobes((1.0 - x.metallic) * (1.0 - largest(F)) * f_lambert(x.base_color),
                    ((1.0 - x.metallic) * F + x.metallic * F_metal) * D_V(x, h, wi, wo));
    if (has_diffuse_transmission || is_transmissive) f.diffuse *= reflected_share(x);
    if (has_energy_compensation) {
        vec3 F_avg = mix(x.specular * mean_schlick(x.F0_dielectric), mean_schlick(x.base_color), x.metallic);
        f.diffuse += f_compensation(x, wi, wo, F_avg);
    }
    return f;
}

vec3 f_metallic_roughness(Surface x, vec3 wi, vec3 wo) {
    Lobes f = metallic_roughness_lobes(x, wi, wo);
    return f.diffuse + f.specular;
}
