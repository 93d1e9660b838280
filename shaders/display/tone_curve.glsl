// Tone curves: exposed linear Rec. 709, not negative, to linear light of a screen in 0..1. Keep in sync with
// src/image/display.cpp, which has the sources; unit.viewer.display compares the two.

vec3 linear(vec3 x) { return x; }

// Narkowicz 2015, "ACES Filmic Tone Mapping Curve".
vec3 aces(vec3 x) { return clamp(x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14), 0.0, 1.0); }

// Khronos 2024, "PBR Neutral Tone Mapper", specification.
vec3 neutral(vec3 c) {
    const float f90 = 0.04;
    const float k_s = 0.8 - f90;
    const float k_d = 0.15;
    float x = min(c.r, min(c.g, c.b));
    float f = x <= 2.0 * f90 ? x - x * x / (4.0 * f90) : f90;
    float p = max(c.r, max(c.g, c.b)) - f;
    if (p <= k_s) return c - f;
    float p_n = 1.0 - (1.0 - k_s) * (1.0 - k_s) / (p + 1.0 - 2.0 * k_s);
    float g = 1.0 / (k_d * (p - p_n) + 1.0);
    return (c - f) * (p_n / p) * g + vec3(p_n * (1.0 - g));
}

// Wrensch 2023, "Minimal AgX Implementation", of Sobotka 2022.
vec3 agx(vec3 exposed) {
    const mat3 inset = mat3(0.842479062253094, 0.0423282422610123, 0.0423756549057051,
                            0.0784335999999992, 0.878468636469772, 0.0784336,
                            0.0792237451477643, 0.0791661274605434, 0.879142973793104);
    const mat3 outset = mat3(1.19687900512017, -0.0528968517574562, -0.0529716355144438,
                             -0.0980208811401368, 1.15190312990417, -0.0980434501171241,
                             -0.0990297440797205, -0.0989611768448433, 1.15107367264116);
    const float min_ev = -12.47393;
    const float max_ev = 4.026069;
    vec3 ev = clamp(log2(max(inset * exposed, 1e-10)), min_ev, max_ev);
    vec3 x = (ev - min_ev) / (max_ev - min_ev);
    vec3 y = (((((15.5 * x - 40.14) * x + 31.96) * x - 6.868) * x + 0.4298) * x + 0.1191) * x - 0.00232;
    return pow(clamp(outset * clamp(y, 0.0, 1.0), 0.0, 1.0), vec3(2.2));
}
