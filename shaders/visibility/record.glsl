// Records the rays instead of tracing them, in the order of the calls, for record.frag to write out. Many
// lights are behind a surface and few lie along its BRDF's peak: only rays that are needed take a place.
// A ray's name is its number + 1, as interface/rays.glsl numbers them.
#include "interface/estimator.glsl"
#include "interface/features.glsl"
#include "surface/surface.glsl"
#include "visibility/named_ray.glsl"
#include "visibility/recorded.glsl"

vec3 visibility(Surface x, vec3 wi, float distance, int light, int ray) {
    int place = recorded_count - first_ray;
    int rays = light_choices > 0 ? light_choices + 1 : rays_per_light;
    if (place >= 0 && place < rays_a_pass) recorded[place] = named_ray(wi, distance, light * rays + ray + 1);
    ++recorded_count;
    return vec3(0.0);
}
