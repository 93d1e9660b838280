// The GGX microfacets of a surface, whether they have a direction or not (ggx.glsl, ggx_anisotropic.glsl).
#include "brdf/ggx_anisotropic.glsl"
#include "brdf/ggx_sampling.glsl"
#include "interface/features.glsl"
#include "surface/surface.glsl"

// D V [1/sr]: all of a microfacet BRDF but its Fresnel term. h: unit, between wi and wo.
float D_V(Surface x, vec3 h, vec3 wi, vec3 wo) {
    float cos_i = dot(x.n, wi);
    float cos_o = max(dot(x.n, wo), 0.0); // n is on the viewer's side; where it was bent there, but for rounding
    if (!has_anisotropy) return D_ggx(x.n, h, x.alpha) * V_smith_ggx(cos_i, cos_o, x.alpha);
    mat3 frame = anisotropic_frame(x.n, x.t);
    vec3 i = vec3((wi * frame).xy, cos_i);
    vec3 o = vec3((wo * frame).xy, cos_o);
    return D_ggx_anisotropic(h * frame, x.alphas) * V_smith_ggx_anisotropic(i, o, x.alphas);
}

vec3 sample_microfacets(Surface x, vec3 wo, vec2 u) {
    if (!has_anisotropy) return sample_ggx(x.n, wo, x.alpha, u);
    return sample_ggx_anisotropic(anisotropic_frame(x.n, x.t), wo, x.alphas, u);
}

float p_microfacets(Surface x, vec3 wi, vec3 wo) {
    if (!has_anisotropy) return p_ggx(x.n, wi, wo, x.alpha);
    return p_ggx_anisotropic(anisotropic_frame(x.n, x.t), wi, wo, x.alphas);
}
