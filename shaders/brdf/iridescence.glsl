// The Fresnel reflectance of a thin film on a base, as KHR_materials_iridescence has it: what interferes between the
// film's two faces, seen by an eye.
//
//   F = Σ_m C_m S_m(m D, m φ),     C_0 = R12 + R_s,   C_m = (R_s - T121) √(R12 R23)^m,   D = 2 n d cosθ2
//
// Belcour & Barla 2017, Eq. 10 (two orders of it) and section 4 (S: the Fourier transform of the observer, fitted by
// Gaussians), with the extension's simplifications: Schlick for both faces, no polarisation, phases 0 or π, and a metal
// stands for a dielectric of its F0. Limits: 0 ≤ F ≤ 1 is enforced, since colours beyond Rec. 709 leave it; under a coat
// the film still borders on air.
#include "base/constants.glsl"
#include "brdf/fresnel.glsl"

vec3 film_sensitivity(float path, vec3 shift) { // path [m]
    float phase = 2.0 * pi * path;
    vec3 weight = vec3(5.4856e-13, 4.4201e-13, 5.2481e-13);
    vec3 place = vec3(1.6810e+06, 1.7953e+06, 2.2084e+06);
    vec3 variance = vec3(4.3278e+09, 9.3046e+09, 6.6121e+09);
    vec3 xyz = weight * sqrt(2.0 * pi * variance) * cos(place * phase + shift) * exp(-phase * phase * variance);
    xyz.x += 9.7470e-14 * sqrt(2.0 * pi * 4.5282e+09) * cos(2.2399e+06 * phase + shift.x) * exp(-4.5282e+09 * phase * phase);
    xyz /= 1.0685e-7;
    return vec3(dot(xyz, vec3(3.2404542, -1.5371385, -0.4985314)), dot(xyz, vec3(-0.9692660, 1.8760108, 0.0415560)),
                dot(xyz, vec3(0.0556434, -0.2040259, 1.0572252))); // IEC 61966-2-1
}

vec3 F_from_iors(vec3 a, vec3 b) {
    vec3 r = (a - b) / (a + b);
    return r * r;
}

// F0: of the base in air. thickness [nm].
vec3 F_thin_film(vec3 F0, float ior, float thickness, float cos_h) {
    float cos2 = sqrt(max(1.0 - (1.0 - cos_h * cos_h) / (ior * ior), 0.0));
    vec3 root = sqrt(clamp(F0, 0.0, 0.9999)); // 1 would be an infinite index of refraction
    vec3 base_ior = (1.0 + root) / (1.0 - root);
    float R12 = F_schlick(F_from_iors(vec3(ior), vec3(1.0)), cos_h).x;
    vec3 R23 = F_schlick(F_from_iors(base_ior, vec3(ior)), cos2);
    float T121 = 1.0 - R12;
    vec3 phi = vec3(pi) + pi * vec3(lessThan(base_ior, vec3(ior)));
    vec3 R123 = clamp(R12 * R23, 1e-5, 0.9999);
    vec3 R_s = T121 * T121 * R23 / (1.0 - R123);
    float path = 2.0e-9 * ior * thickness * cos2;
    vec3 F = vec3(R12) + R_s;
    vec3 C = R_s - T121;
    for (int m = 1; m <= 2; ++m) {
        C *= sqrt(R123);
        F += C * 2.0 * film_sensitivity(float(m) * path, float(m) * phi);
    }
    // Thinner than an atom a film is none; the model has its two faces still.
    return mix(F_schlick(F0, cos_h), clamp(F, 0.0, 1.0), smoothstep(0.0, 0.03, thickness));
}
