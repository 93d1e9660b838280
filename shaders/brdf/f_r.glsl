// f_r(x, wi, wo): the BRDF of the surface [1/sr]. Never the cosine, never the light.
// Overlay this file to render with another one.
#include "brdf/model.glsl"

vec3 f_r(Surface x, vec3 wi, vec3 wo) { return f_model(x, wi, wo); }
