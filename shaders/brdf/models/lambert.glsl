// Lambert, and nothing over it.
#include "brdf/lambert.glsl"
#include "brdf/models/diffuse_model.glsl"

vec3 f_r(Surface x, vec3 wi, vec3 wo) { return f_lambert(x.base_color) * float(dot(x.n, wi) > 0.0); }
