// The layers that glTF puts over a material: sheen, and over that a coat.
//
//   coated = mix(below, D V n_c·wi / n·wi, c (0.04 + 0.96 (1 - n_c·wo)⁵))
//   below  = sheen colour f_charlie / max(E, 1) + base (1 - s min(E, 1)),    E = max(E(wi), E(wo)), s = max(sheen colour)
//
// KHR_materials_clearcoat, "Layering": D V with the coat's own roughness and normal n_c. The quotient of cosines lets a
// bumpy coat shine as its own normal has it, under the one cosine of the integral. Limit: the weight takes wo alone, as
// the extension has it, so that a coated material is not reciprocal. KHR_materials_sheen, "Albedo-scaling technique" (both
// directions, so that this layer is). There f_charlie is not divided; but below a roughness of 0.26 the fitted Λ sends back more than
// arrives at grazing (E up to 18), and E = 1 is where that ends.
#include "base/unit.glsl"
#include "brdf/albedo_table.glsl"
#include "brdf/charlie.glsl"
#include "brdf/coat.glsl"
#include "brdf/ggx_sampling.glsl"
#include "brdf/lobe_sum.glsl"
#include "interface/features.glsl"
#include "surface/surface.glsl"

vec3 under_sheen(Surface x, vec3 base, vec3 wi, vec3 wo) {
    float cos_i = dot(x.n, wi);
    float cos_o = max(dot(x.n, wo), 0.0);
    if (has_diffuse_transmission && cos_i <= 0.0)
        return base * (1.0 - largest(x.sheen_color) * min(E_charlie(cos_o, x.sheen_alpha), 1.0));
    if (cos_i <= 0.0) return vec3(0.0);
    float E = max(E_charlie(cos_i, x.sheen_alpha), E_charlie(cos_o, x.sheen_alpha));
    float f = f_charlie(x.n, wi, wo, x.sheen_alpha) / max(E, 1.0);
    return x.sheen_color * f + base * (1.0 - largest(x.sheen_color) * min(E, 1.0));
}

vec3 under_coat(Surface x, vec3 below, vec3 wi, vec3 wo) {
    float cos_i = dot(x.clearcoat_n, wi);
    float cos_base = dot(x.n, wi);
    float weight = coat_weight(x, wo);
    if (cos_i <= 0.0 || cos_base <= 0.0) return below * (1.0 - weight);
    float cos_o = max(dot(x.clearcoat_n, wo), 0.0);
    float DV = D_ggx(x.clearcoat_n, half_vector(wi, wo, x.clearcoat_n), x.clearcoat_alpha) * V_smith_ggx(cos_i, cos_o, x.clearcoat_alpha);
    return mix(below, vec3(DV * cos_i / cos_base), weight);
}

// base: f_r of the material below.
vec3 layered(Surface x, vec3 base, vec3 wi, vec3 wo) {
    vec3 f = has_sheen ? under_sheen(x, base, wi, wo) : base;
    return has_clearcoat ? under_coat(x, f, wi, wo) : f;
}
