// Where visibility/record.glsl leaves the rays.
#include "interface/rays.glsl"

vec4 recorded[rays_a_pass]; // wi, distance [m]; distance 0: no ray
