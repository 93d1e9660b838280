// V as the CPU found it for the rays that record.glsl noted down: a plane of the answers for each ray.
#include "interface/features.glsl"
#include "interface/rays.glsl"
#include "surface/surface.glsl"

uniform samplerBuffer answers;

vec3 visibility(Surface x, vec3 wi, float distance, int light, int ray) {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    int plane = light * rays_per_light + ray - first_ray;
    return vec3(texelFetch(answers, plane * plane_size + (pixel.y - first_row) * row_size + pixel.x).r);
}
