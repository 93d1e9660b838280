// Lambert of the base colour and a lobe of the specular colour. Colours whose sum exceeds 1 create energy.
#include "brdf/phong.glsl"
#include "brdf/lambert.glsl"
#include "brdf/models/no_lobes.glsl"
#include "interface/material.glsl"

float phong_exponent() { return model_parameters[0].x; }

vec3 f_r(Surface x, vec3 wi, vec3 wo) {
    if (dot(x.n, wi) <= 0.0) return vec3(0.0);
    return f_lambert(x.base_color) + x.specular_color * f_phong(x.n, wi, wo, phong_exponent());
}

bool has_peak(Surface x) { return x.specular_color != vec3(0.0); }
vec3 sample_f_r(Surface x, vec3 wo, vec2 u) { return sample_phong(x.n, wo, phong_exponent(), u); }
float pdf_f_r(Surface x, vec3 wi, vec3 wo) { return p_phong(x.n, wi, wo, phong_exponent()); }
float peak_alpha(Surface x) { return clamp(sqrt(2.0 / (phong_exponent() + 2.0)), min_alpha, 1.0); }
