// Lambert of the base colour and a lobe of the specular colour. Colours whose sum exceeds 1 create energy.
#include "brdf/blinn_phong.glsl"
#include "brdf/lambert.glsl"
#include "brdf/models/no_lobes.glsl"

vec3 f_model(Surface x, vec3 wi, vec3 wo) {
    if (dot(x.n, wi) <= 0.0) return vec3(0.0);
    return f_lambert(x.base_color) + x.specular_color * f_blinn_phong(x.n, wi, wo, x.exponent);
}

bool model_has_peak(Surface x) { return x.specular_color != vec3(0.0); }
vec3 sample_model(Surface x, vec3 wo, vec2 u) { return sample_blinn_phong(x.n, wo, x.exponent, u); }
float p_model(Surface x, vec3 wi, vec3 wo) { return p_blinn_phong(x.n, wi, wo, x.exponent); }
