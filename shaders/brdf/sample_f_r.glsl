// Directions in which f_r has its peak, if it has one: the specular lobe. What the lobe leaves out is found by
// sampling the lights, so no direction is lost (see integrator/reflected.glsl). Overlay it together with f_r.glsl.
#include "brdf/ggx_sampling.glsl"
#include "surface/surface.glsl"

bool has_peak(Surface x) { return x.metallic > 0.0 || x.specular > 0.0; }

vec3 sample_f_r(Surface x, vec3 wo, vec2 u) { return sample_ggx(x.n, wo, x.alpha, u); }

// The density of sample_f_r [1/sr]; 0 for surfaces without a peak, which are not to be sampled by it.
float p_f_r(Surface x, vec3 wi, vec3 wo) { return has_peak(x) ? p_ggx(x.n, wi, wo, x.alpha) : 0.0; }
