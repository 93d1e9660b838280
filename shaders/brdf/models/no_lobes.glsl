// For BRDFs that the analytic estimator does not take: it is not asked to (Features::is_analytic), and this is never run.
#include "brdf/lobe_sum.glsl"
#include "surface/surface.glsl"

Lobes model_lobes(Surface x, vec3 wi, vec3 wo) { return Lobes(vec3(0.0), vec3(0.0)); }
bool model_has_diffuse_lobe(Surface x) { return false; }
bool model_has_specular_lobe(Surface x) { return false; }
vec3 model_specular_albedo(Surface x, float DV, float schlick) { return vec3(0.0); }
