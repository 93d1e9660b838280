// L V(x, y): what of the light L from one point of an emitter arrives where it is measured. V is the only factor of a
// sample that the shader may leave to others: the renderer replaces this file by deferred.glsl where the CPU traces the
// rays.
#include "surface/surface.glsl"
#include "visibility/visibility.glsl"

vec3 seen(vec3 L, Surface x, vec3 wi, float distance, int light, int ray) {
    return L * visibility(x, wi, distance, light, ray);
}
