// Light k as it arrives at x.
#include "interface/features.glsl"
#include "light/punctual.glsl"
#include "light/rectangle.glsl"

// In a direction of the light's choice; emitters without extent ignore the random numbers u.
LightSample sample_light(int k, vec3 x, vec2 u) {
    Light light = light_at(k);
    if (has_rectangle_lights && light.kind == rectangle_light) return sample_rectangle(light, x, u);
    if (has_spot_lights && light.kind == spot_light) return sample_spot(light, x);
    if (has_directional_lights && light.kind == directional_light) return sample_directional(light);
    if (light.kind == point_light) return sample_point(light, x);
    return no_light;
}

// In the direction wi: p = 0 where the light is not met.
LightSample light_along(int k, vec3 x, vec3 wi) {
    Light light = light_at(k);
    if (light.kind == rectangle_light) return rectangle_along(light, x, wi);
    return no_light;
}
