#version 410 core
// forward.frag for a surface that light goes straight through (KHR_materials_transmission):
//
//   L_o(x, wo) = L_e(x, wo) + Σ_k ∫ f_r L_i V cosθ_i dω + T(wo) L_o(x', wo)
//
// x' is the surface behind, which stands in the frame already: blending multiplies it by `through` and adds `film`.
#include "surface/surface.glsl"
#include "integrator/bounded.glsl"
#include "integrator/emitted.glsl"
#include "integrator/reflected.glsl"
#include "surface/at_fragment.glsl"

layout(location = 0, index = 0) out vec4 film;    // L_o without what is behind [cd/m²] times alpha, and coverage
layout(location = 0, index = 1) out vec4 through; // what of the frame's radiance is left, and of its coverage

void main() {
    Surface x = surface_at_fragment();
    vec3 L_o = emitted(x) + reflected(x, direction_to_viewer());
    film = vec4(bounded(L_o) * x.alpha_coverage, x.coverage);
    through = vec4(x.through, 1.0 - x.coverage);
}
