// The material of glTF 2.0: a metal and a coated diffuse dielectric that share one GGX lobe.
//
//   f_r        = mix(dielectric, metal, metallic)
//   metal      = F(base colour) D V
//   dielectric = (1 - s max F(F0)) ρ/π + s F(F0) D V
//
// glTF 2.0 specification, Appendix B.2 and B.3; s, F0 and the maximum: KHR_materials_specular and KHR_materials_ior.
// For materials that are half metal the appendix's closing simplification (B.3.5) weighs the diffuse part with the
// blended F instead; the definition above is used. No energy compensation: rough metals lose what bounces twice.
#include "brdf/fresnel.glsl"
#include "brdf/ggx.glsl"
#include "brdf/lambert.glsl"
#include "surface/surface.glsl"

float largest(vec3 v) { return max(v.x, max(v.y, v.z)); }

struct Lobes {
    vec3 diffuse;  // [1/sr]
    vec3 specular; // [1/sr]
};

Lobes metallic_roughness_lobes(Surface x, vec3 wi, vec3 wo) {
    float cos_i = dot(x.n, wi);
    float cos_o = dot(x.n, wo);
    if (cos_i <= 0.0 || cos_o < 0.0) return Lobes(vec3(0.0), vec3(0.0));

    vec3 h = normalize(wi + wo);
    float cos_h = dot(wo, h);
    float DV = D_ggx(x.n, h, x.alpha) * V_smith_ggx(cos_i, cos_o, x.alpha);

    vec3 F = x.specular * F_schlick(x.F0_dielectric, cos_h);
    vec3 F_metal = F_schlick(x.base_color, cos_h);
    return Lobes((1.0 - x.metallic) * (1.0 - largest(F)) * f_lambert(x.base_color), mix(F, F_metal, x.metallic) * DV);
}

vec3 f_metallic_roughness(Surface x, vec3 wi, vec3 wo) {
    Lobes f = metallic_roughness_lobes(x, wi, wo);
    return f.diffuse + f.specular;
}
