// A shadow ray as the CPU reads it: from x to the emitter's point [m], and the ray's number + 1. A light without a place
// has wi there, and the negated number.
#include "interface/estimator.glsl"
#include "interface/features.glsl"

const float nowhere = 1e30; // the distance of lights that have no place

vec4 named_ray(vec3 wi, float distance, int light, int ray) {
    int rays = light_choices > 0 ? light_choices + 1 : rays_per_light;
    float name = float(light * rays + ray + 1);
    return distance < nowhere ? vec4(distance * wi, name) : vec4(wi, -name);
}
