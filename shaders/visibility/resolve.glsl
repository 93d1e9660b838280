// V as the CPU found it for the rays that record.glsl wrote down.
#include "interface/estimator.glsl"
#include "interface/features.glsl"
#include "interface/rays.glsl"
#include "surface/surface.glsl"

uniform samplerBuffer ray_visibility; // a plane for each ray

vec3 visibility(Surface x, vec3 wi, float distance, int light, int ray) {
    int plane = light_choices > 0 ? ray : light * rays_per_light + ray - first_ray;
    vec3 V = texelFetch(ray_visibility, plane * plane_size + pixel_of_rows()).rgb;
    return has_tinted_casters ? V : vec3(V.r); // without glass V has one channel
}
