// Directions in which f_r has its peak, if it has one. What the peak leaves out is found by sampling the lights, so no
// direction is lost (see integrator/reflected.glsl). Overlay it together with f_r.glsl.
#include "brdf/model.glsl"

bool has_peak(Surface x) { return model_has_peak(x); }

vec3 sample_f_r(Surface x, vec3 wo, vec2 u) { return sample_model(x, wo, u); }

// The density of sample_f_r [1/sr]; 0 for surfaces without a peak, which are not to be sampled by it.
float p_f_r(Surface x, vec3 wi, vec3 wo) { return has_peak(x) ? p_model(x, wi, wo) : 0.0; }
