// The renderer's f_r: the student's f_ggx with the base colour as F0.
#include "surface/surface.glsl"
#include "microfacets.glsl"

vec3 f_r(Surface x, vec3 wi, vec3 wo) { return f_ggx(x.n, wi, wo, x.base_color, x.alpha); }
