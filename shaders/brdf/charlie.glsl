// Sheen: fibres that stand around the normal, as KHR_materials_sheen has it.
//
//   D(h) = (2 + 1/α) sin(h)^(1/α) / 2π,    f = D V,    V = 1 / ((1 + Λ(wi) + Λ(wo)) 4 cos_i cos_o)          [1/sr]
//
// Conty Estevez & Kulla 2017, Eq. 2 (D), section 2 and table 1 (Λ, fitted). Limits: 0 < α <= 1. The fit of Λ ends at 3e7,
// where the true one grows without bound, so cosines below 1e-4 count as that.
#include "base/constants.glsl"
#include "base/unit.glsl"

float D_charlie(float cos_h, float alpha) {
    float sin2 = max(1.0 - cos_h * cos_h, 0.0);
    return (2.0 + 1.0 / alpha) * pow(sin2, 0.5 / alpha) / (2.0 * pi);
}

float log_lambda_charlie(float c, float alpha) {
    float t = (1.0 - alpha) * (1.0 - alpha);
    return mix(21.5473, 25.3245, t) / (1.0 + mix(3.82987, 3.32435, t) * pow(c, mix(0.19823, 0.16801, t)))
           + mix(-1.97760, -1.27393, t) * c + mix(-4.32054, -4.85967, t);
}

float lambda_charlie(float c, float alpha) {
    if (c < 0.5) return exp(log_lambda_charlie(c, alpha));
    return exp(2.0 * log_lambda_charlie(0.5, alpha) - log_lambda_charlie(1.0 - c, alpha));
}

float f_charlie(vec3 n, vec3 wi, vec3 wo, float alpha) {
    float cos_i = clamp(dot(n, wi), 1e-4, 1.0); // a cosine rounded to above 1 has no power of 1 - c
    float cos_o = clamp(dot(n, wo), 1e-4, 1.0);
    float shadowing = 1.0 + lambda_charlie(cos_i, alpha) + lambda_charlie(cos_o, alpha);
    return D_charlie(dot(n, half_vector(wi, wo, n)), alpha) / (shadowing * 4.0 * cos_i * cos_o);
}
