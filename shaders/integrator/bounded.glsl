// Keeps the film's sum over frames a float, whatever a file states. What is no number stays none, so that mistakes show.
const float max_radiance = 1e30; // [cd/m²]

// By bits: drivers may turn a comparison into min(), which has no NaN.
bvec3 is_nan(vec3 v) { return greaterThan(floatBitsToUint(v) & 0x7fffffffu, uvec3(0x7f800000u)); }

vec3 bounded(vec3 L_o) { return mix(min(L_o, vec3(max_radiance)), L_o, is_nan(L_o)); }
