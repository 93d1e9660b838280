// What is left of light k's L_r, found by its samples, where their V is not the whole answer. It is unless the renderer
// puts shadowed_by_maps.glsl in the place of this file.
#include "surface/surface.glsl"

vec3 shadowed(vec3 L_r, int k, Surface x, vec3 wo) { return L_r; }
