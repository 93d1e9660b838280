#version 410 core
// A mistake on purpose: the film is encoded for a screen, which the display transform does once more.
// Else as shaders/forward.frag:
//
//   L_o(x, wo) = L_e(x, wo) + Σ_k ∫ f_r L_i V cosθ_i dω
#include "integrator/emitted.glsl"
#include "integrator/reflected.glsl"
#include "surface/at_fragment.glsl"

out vec4 film; // L_o [cd/m²] times coverage, and coverage

vec3 srgb_encoded(vec3 v) { return mix(12.92 * v, 1.055 * pow(v, vec3(1.0 / 2.4)) - 0.055, greaterThan(v, vec3(0.0031308))); }

void main() {
    Surface x = surface_at_fragment();
    vec3 wo = direction_to_viewer();
    vec3 L_o = srgb_encoded(is_unlit ? x.base_color : emitted(x) + reflected(x, wo));
    film = vec4(L_o * x.coverage, x.coverage);
}
