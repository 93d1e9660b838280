// V(x, y) = 1: every emitter is seen from everywhere (--visibility none).
#include "surface/surface.glsl"

vec3 visibility(Surface x, vec3 wi, float distance, int light, int ray) { return vec3(1.0); }
