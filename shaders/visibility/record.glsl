// Records the rays instead of tracing them, in the order of the calls, for record.frag to write out. Many
// lights are behind a surface and few lie along its BRDF's peak: only rays that are needed take a place.
#include "interface/estimator.glsl"
#include "interface/features.glsl"
#include "surface/surface.glsl"
#include "visibility/recorded.glsl"

const float nowhere = 1e30; // the distance of lights that have no place

vec3 visibility(Surface x, vec3 wi, float distance, int light, int ray) {
    int rays = light_choices > 0 ? light_choices + 1 : rays_per_light;
    float name = float(light * rays + ray + 1);
    vec4 entry = distance < nowhere ? vec4(distance * wi, name) : vec4(wi, -name);
    int place = recorded_count - first_ray;
    if (place >= 0 && place < rays_a_pass) recorded[place] = entry;
    ++recorded_count;
    return vec3(0.0);
}
