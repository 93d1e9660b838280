// The rays that visibility/record.glsl has recorded.
#include "interface/rays.glsl"

// xyz: from x to the emitter's point [m]; w: the ray's number + 1. Lights without a place: wi, and w negated.
vec4 recorded[rays_a_pass];
int recorded_count; // asked so far by this pixel, noted or not
