// V(x, y) by a ray: the product of what the surfaces between x and the emitter's point let through.
#include "visibility/bvh.glsl"

vec3 visibility(Surface x, vec3 wi, float distance, int light, int ray) {
    return transmittance(ray_from(x, wi, distance), light);
}
