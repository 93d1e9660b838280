#version 410 core
// The rendering equation for direct light, at the surface that the pixel sees:
//
//   L_o(x, wo) = L_e(x, wo) + Σ_k ∫ f_r L_i V cosθ_i dω
#include "integrator/bounded.glsl"
#include "integrator/emitted.glsl"
#include "integrator/reflected.glsl"
#include "surface/at_fragment.glsl"

out vec4 film; // L_o [cd/m²] times coverage, and coverage

void main() {
    Surface x = surface_at_fragment();
    vec3 wo = direction_to_viewer();
    vec3 L_o = is_unlit ? unlit(x) : emitted(x) + reflected(x, wo);
    film = vec4(bounded(L_o) * x.coverage, x.coverage);
}
