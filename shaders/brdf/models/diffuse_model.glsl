// The common part of BRDFs without a peak. The lights' own points find all there is, so nothing is gained by directions of the
// BRDF's choice.
#include "brdf/cosine_sampling.glsl"
#include "brdf/lobe_sum.glsl"
#include "surface/surface.glsl"

vec3 f_r(Surface x, vec3 wi, vec3 wo);

bool has_peak(Surface x) { return false; }
vec3 sample_f_r(Surface x, vec3 wo, vec2 u) { return sample_cosine(x.n, u); }
float pdf_f_r(Surface x, vec3 wi, vec3 wo) { return p_cosine(x.n, wi); }
float peak_alpha(Surface x) { return 1.0; }

Lobes lobes(Surface x, vec3 wi, vec3 wo) { return Lobes(f_r(x, wi, wo), vec3(0.0)); }
bool has_diffuse_lobe(Surface x) { return true; }
bool has_specular_lobe(Surface x) { return false; }
vec3 specular_albedo(Surface x, float DV, float schlick) { return vec3(0.0); }
