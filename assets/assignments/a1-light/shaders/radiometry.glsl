// A1.6 and A1.7: flux, intensity, irradiance and radiance. Distances are in m.
#include "assignment/not_implemented.glsl"
#include "base/constants.glsl"
#include "parameters.glsl"

// Given: the intensity of a lamp [cd] that hangs from a ceiling and shines down, at the angle θ from straight down.
float I(float theta, float I_0, float m) { return theta < 0.5 * pi ? I_0 * pow(cos(theta), m) : 0.0; }

// begin solution A1.6
// Φ = ∫ I dω over all directions                                                       [lm]
//
// By the antiderivative, or by a sum of 200 steps or more.
float flux(float I_0, float m) { return 2.0 * pi * I_0 / (m + 1.0); }

// Φ of your lamp: lamp_intensity [cd] and lamp_exponent stand in parameters.glsl.
float flux_of_your_lamp() { return flux(lamp_intensity, lamp_exponent); }

// E = I / r²: the irradiance of a surface at distance r that faces the lamp             [lx]
float E_facing(float intensity, float r) { return intensity / (r * r); }
// end

// begin solution A1.7
// L = Φ / (A cosθ ω)                                                                   [cd/m²]
//
// The flux Phi [lm] goes through a small area A [m²] into a small solid angle omega [sr]. cos_theta is the cosine
// between the normal of A and the direction.
float radiance(float Phi, float A, float cos_theta, float omega) { return Phi / (A * cos_theta * omega); }

// Φ = L A_1 cosθ_1 A_2 cosθ_2 / r²                                                     [lm]
//
// What a small area of radiance L [cd/m²] sends through another one at the distance r.
float flux_between(float L, float A_1, float cos_1, float A_2, float cos_2, float r) {
    return L * A_1 * cos_1 * A_2 * cos_2 / (r * r);
}
// end
