// The first of the frame's points on a light that depth maps were made from, and its V.
#include "integrator/rays.glsl"
#include "light/map_sample.glsl"
#include "visibility/map.glsl"

LightSample point_on_light(int k, Surface x) {
    if (!has_extent(k)) return sample_light(k, x.position, vec2(0.0));
    return sample_from_point(k, map_point(k, 0), x.position);
}

vec3 V_of_point(int k, Surface x, LightSample light) {
    return V_by_map(x, map_point(k, 0), light.wi, light.distance, k);
}
