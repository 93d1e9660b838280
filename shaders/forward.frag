#version 410 core
// The rendering equation for direct light, at the surface that the pixel sees:
//
//   L_o(x, wo) = L_e(x, wo) + Σ_k ∫ f_r L_i V cosθ_i dω
#include "surface/surface.glsl"
#include "integrator/bounded.glsl"
#include "integrator/outgoing.glsl"
#include "surface/at_fragment.glsl"

out vec4 film; // L_o [cd/m²] times coverage, and coverage

void main() {
    Surface x = surface_at_fragment();
    vec3 L_o = outgoing(x, direction_to_viewer());
    film = vec4(bounded(L_o) * x.coverage, x.coverage);
}
