// A BRDF with all that the integrators read of it. Beside f_r, a file of models/ declares
//
//   bool has_peak(x)               whether sampling f_r finds what sampling the lights does not
//   vec3 sample_f_r(x, wo, u)      a direction
//   float pdf_f_r(x, wi, wo)       its density [1/sr]
//   float peak_alpha(x)            the width of the GGX lobe that is as wide as its peak
//   Lobes lobes(x, wi, wo)         f_r in two summands; with what goes with them, for the analytic estimator
//
// Where a folder overlays f_r.glsl, the renderer takes from the model what that file does not declare.
#include "brdf/f_r.glsl"
