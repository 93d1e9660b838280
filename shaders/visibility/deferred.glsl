// Leaves V to the CPU: each sample that could add something is written down with its ray, and adds nothing here. The ray's
// name is the light's number + 1.
#include "interface/deferred.glsl"
#include "surface/surface.glsl"
#include "visibility/named_ray.glsl"

vec3 seen(vec3 L, Surface x, vec3 wi, float distance, int light, int ray) {
    if (L == vec3(0.0)) return vec3(0.0);
    int first = deferred_pairs_of(pixel_of_rows()) + receiver_pairs + sample_pairs * deferred_count;
    vec4 named = named_ray(wi, distance, light + 1);
    deferred[first] = pair(named.x, named.y);
    deferred[first + 1] = pair(named.z, named.w);
    deferred[first + 2] = pair(L.r, L.g);
    deferred[first + 3] = pair(L.b, 0.0);
    ++deferred_count;
    return vec3(0.0);
}
