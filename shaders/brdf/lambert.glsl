// Lambert: the same radiance in all directions.
//
//   f_r = ρ / π          [1/sr]
//
// Lambert 1760; ρ is the albedo, the fraction of the light that leaves again.
#include "base/constants.glsl"

vec3 f_lambert(vec3 albedo) { return albedo / pi; }
