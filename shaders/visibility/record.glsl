// Does not answer but notes the rays down, each in its place, for record.frag to write out.
#include "interface/features.glsl"
#include "surface/surface.glsl"
#include "visibility/recorded.glsl"

float visibility(Surface x, vec3 wi, float distance, int light, int ray) {
    int place = light * rays_per_light + ray - first_ray;
    if (place >= 0 && place < rays_a_pass) recorded[place] = vec4(wi, distance);
    return 0.0;
}
