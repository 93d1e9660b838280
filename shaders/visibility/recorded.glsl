// The rays that visibility/record.glsl has recorded.
#include "interface/rays.glsl"

vec4 recorded[rays_a_pass];
int recorded_count; // asked so far by this pixel, noted or not
