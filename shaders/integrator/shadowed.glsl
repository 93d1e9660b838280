// Shadow correction of light k's L_r where the V of its samples is not complete. It is complete here; the renderer
// replaces this file by shadowed_by_maps.glsl for depth maps.
#include "surface/surface.glsl"

vec3 shadowed(vec3 L_r, int k, Surface x, vec3 wo) { return L_r; }
