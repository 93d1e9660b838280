// L_e(x, wo): the light that the surface itself sends out [cd/m²].
// Flat emitters emit on their front; backs of single-sided surfaces are never drawn (glTF culls them).
#include "interface/features.glsl"
#include "surface/surface.glsl"

vec3 emitted(Surface x) { return x.emission; }

// L_o of what no light touches: the base colour (KHR_materials_unlit); of lines and points without normals also L_e
// (glTF 2.0, section 3.9.7).
vec3 unlit(Surface x) { return is_line || is_point ? x.base_color + x.emission : x.base_color; }
