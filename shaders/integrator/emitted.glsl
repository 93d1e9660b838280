// L_e(x, wo): the light that the surface itself sends out [cd/m²].
// Flat emitters emit on their front; backs of single-sided surfaces are never drawn (glTF culls them).
#include "surface/surface.glsl"

vec3 emitted(Surface x) { return x.emission; }
