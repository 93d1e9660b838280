// Leaves V to the CPU: each sample that could add something is written down with its ray, and adds nothing here.
#include "interface/deferred.glsl"
#include "surface/surface.glsl"
#include "visibility/named_ray.glsl"

vec3 seen(vec3 L, Surface x, vec3 wi, float distance, int light, int ray) {
    if (L == vec3(0.0)) return vec3(0.0);
    int first = deferred_words_of(pixel_of_rows()) + receiver_words + sample_words * deferred_count;
    ivec4 named = floatBitsToInt(named_ray(wi, distance, light, ray));
    ivec3 bits = floatBitsToInt(L);
    for (int i = 0; i < 4; ++i) deferred[first + i] = named[i];
    for (int i = 0; i < 3; ++i) deferred[first + 4 + i] = bits[i];
    ++deferred_count;
    return vec3(0.0);
}
