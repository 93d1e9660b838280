// The density of what sample_f_r draws, also for BRDFs without a peak, which the renderer does not draw from.
#include "surface/surface.glsl"
#include "brdf/model.glsl"
#include "brdf/sample_f_r.glsl"

float density(Surface x, vec3 wi, vec3 wo) { return has_peak(x) ? p_f_r(x, wi, wo) : p_model(x, wi, wo); }
