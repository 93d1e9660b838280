// Oren-Nayar, which keeps its energy: rough clay, moon, cloth.
//
//   f_r = ρ/π A (1 + r s/t) + ρ_ms/π (1 - E(wi)) (1 - E(wo)) / (1 - E_avg)                    [1/sr]
//
//   s = wi·wo - cos_i cos_o,    t = max(cos_i, cos_o) where s > 0, else 1,    A = 1 / (1 + r c1),
//   E(w) = A (1 + r G(w)/π),    E_avg = A (1 + r c2),    ρ_ms = ρ² E_avg / (1 - ρ (1 - E_avg))
//
// Portsmouth, Kutz & Hill 2024, "EON: A practical energy-preserving rough diffuse BRDF", with the exact E. A, r(c1 - G/π)
// and so on are taken out of 1 - E and 1 - E_avg, so that r = 0 (Lambert) is no special case. 0 ≤ r ≤ 1, cosines above 0.
#include "base/angle.glsl"
#include "base/constants.glsl"

const float oren_nayar_c1 = 0.5 - 2.0 / (3.0 * pi);
const float oren_nayar_c2 = 2.0 / 3.0 - 28.0 / (15.0 * pi);

// c1 - G/π, with G = s (acos c - s c) + (2/3) (s (1 - s³)/c - s) and (1 - s³)/c = c (1 + s + s²) / (1 + s).
float oren_nayar_lack(float c) {
    float s = sqrt(max(1.0 - c * c, 0.0));
    float G = s * (angle_of(vec2(c, s)) - s * c) + 2.0 / 3.0 * (s * c * (1.0 + s + s * s) / (1.0 + s) - s);
    return oren_nayar_c1 - G / pi;
}

vec3 f_oren_nayar(vec3 albedo, float r, vec3 n, vec3 wi, vec3 wo) {
    float cos_i = dot(n, wi);
    float cos_o = max(dot(n, wo), 0.0);
    float A = 1.0 / (1.0 + r * oren_nayar_c1);
    float s = dot(wi, wo) - cos_i * cos_o;
    vec3 once = albedo * A * (1.0 + r * (s > 0.0 ? s / max(cos_i, cos_o) : s));
    float E_avg = A * (1.0 + r * oren_nayar_c2);
    float lost = r * A * oren_nayar_lack(cos_i) * oren_nayar_lack(cos_o) / (oren_nayar_c1 - oren_nayar_c2);
    return (once + albedo * albedo * E_avg / (1.0 - albedo * (1.0 - E_avg)) * lost) / pi;
}
