// Lambert, and nothing over it.
#include "brdf/lambert.glsl"
#include "brdf/models/diffuse_sampling.glsl"

vec3 f_model(Surface x, vec3 wi, vec3 wo) { return f_lambert(x.base_color) * float(dot(x.n, wi) > 0.0); }
Lobes model_lobes(Surface x, vec3 wi, vec3 wo) { return Lobes(f_model(x, wi, wo), vec3(0.0)); }
