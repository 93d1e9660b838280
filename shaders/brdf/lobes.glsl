// f_r in two summands, for estimators that integrate each in a way of its own: what scatters everywhere, and the GGX
// lobe. Overlay it together with f_r.glsl.
#include "brdf/model.glsl"

Lobes lobes(Surface x, vec3 wi, vec3 wo) { return model_lobes(x, wi, wo); }

bool has_diffuse_lobe(Surface x) { return model_has_diffuse_lobe(x); }
bool has_specular_lobe(Surface x) { return model_has_specular_lobe(x); }

// The specular lobe's part of the albedo, from ∫ D V cosθ and ∫ (1 - w·h)⁵ D V cosθ.
vec3 specular_albedo(Surface x, float DV, float schlick) { return model_specular_albedo(x, DV, schlick); }
