// The lobes of BRDFs that the analytic estimator does not integrate (BrdfModel::is_analytic). They are never evaluated.
#include "brdf/lobe_sum.glsl"
#include "surface/surface.glsl"

Lobes lobes(Surface x, vec3 wi, vec3 wo) { return Lobes(vec3(0.0), vec3(0.0)); }
bool has_diffuse_lobe(Surface x) { return false; }
bool has_specular_lobe(Surface x) { return false; }
vec3 specular_albedo(Surface x, float DV, float schlick) { return vec3(0.0); }
