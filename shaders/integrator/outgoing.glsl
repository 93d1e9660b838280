// The radiance that a surface sends to the viewer, by direct light [cd/m²]:
//
//   L_o(x, wo) = L_e(x, wo) + Σ_k ∫ f_r L_i V cosθ_i dω
#include "surface/surface.glsl"
#include "integrator/emitted.glsl"
#include "integrator/reflected.glsl"

// Radiance of unlit surfaces: the base colour (KHR_materials_unlit); of lines and points without normals also L_e (glTF 2.0,
// section 3.9.7).
vec3 unlit(Surface x) { return is_line || is_point ? x.base_color + emitted(x) : x.base_color; }

vec3 outgoing(Surface x, vec3 wo) { return is_unlit ? unlit(x) : emitted(x) + reflected(x, wo); }
