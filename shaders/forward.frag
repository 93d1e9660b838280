#version 410 core
// The rendering equation for direct light, at the surface that the pixel sees:
//
//   L_o(x, wo) = L_e(x, wo) + Σ_k ∫ f_r L_i V cosθ_i dω
#include "surface/surface.glsl"
#include "integrator/bounded.glsl"
#include "integrator/emitted.glsl"
#include "integrator/reflected.glsl"
#include "surface/at_fragment.glsl"

out vec4 film; // L_o [cd/m²] times coverage, and coverage

// Radiance of unlit surfaces: the base colour (KHR_materials_unlit); of lines and points without normals also L_e (glTF 2.0,
// section 3.9.7).
vec3 unlit(Surface x) { return is_line || is_point ? x.base_color + emitted(x) : x.base_color; }

void main() {
    Surface x = surface_at_fragment();
    vec3 wo = direction_to_viewer();
    vec3 L_o = is_unlit ? unlit(x) : emitted(x) + reflected(x, wo);
    film = vec4(bounded(L_o) * x.coverage, x.coverage);
}
