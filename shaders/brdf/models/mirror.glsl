// An ideal mirror of reflectance ρ (the base colour): f_r is zero but in one direction, where it is beyond numbers.
//
//   f_r = ρ δ(wi - m) / cosθ_i,    m = 2 (n·wo) n - wo
//
// so L_r = ρ L_i(m), which integrator/mirrored.glsl evaluates. A direction of density 1/0 stands for none: there is no sampling.
#include "brdf/models/no_lobes.glsl"

vec3 f_r(Surface x, vec3 wi, vec3 wo) { return vec3(0.0); }

bool has_peak(Surface x) { return false; }
vec3 sample_f_r(Surface x, vec3 wo, vec2 u) { return reflect(-wo, x.n); }
float pdf_f_r(Surface x, vec3 wi, vec3 wo) { return 0.0; }
float peak_alpha(Surface x) { return min_alpha; }
