// sample_light(k, x, u): light k as it arrives at x. Emitters without extent ignore the random numbers u.
#include "interface/features.glsl"
#include "light/punctual.glsl"
#include "light/rectangle.glsl"

LightSample sample_light(int k, vec3 x, vec2 u) {
    Light light = light_at(k);
    if (has_rectangle_lights && light.kind == rectangle_light) return sample_rectangle(light, x, u);
    if (has_spot_lights && light.kind == spot_light) return sample_spot(light, x);
    if (has_directional_lights && light.kind == directional_light) return sample_directional(light);
    return sample_point(light, x);
}
