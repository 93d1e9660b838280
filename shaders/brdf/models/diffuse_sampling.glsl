// For BRDFs without a peak: the lights' own points find all there is, so nothing is gained by directions of the BRDF's choice.
#include "brdf/cosine_sampling.glsl"
#include "brdf/lobe_sum.glsl"
#include "surface/surface.glsl"

bool model_has_peak(Surface x) { return false; }
vec3 sample_model(Surface x, vec3 wo, vec2 u) { return sample_cosine(x.n, u); }
float p_model(Surface x, vec3 wi, vec3 wo) { return p_cosine(x.n, wi); }

bool model_has_diffuse_lobe(Surface x) { return true; }
bool model_has_specular_lobe(Surface x) { return false; }
vec3 model_specular_albedo(Surface x, float DV, float schlick) { return vec3(0.0); }
