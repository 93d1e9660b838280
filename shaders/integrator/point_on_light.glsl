// One point on a light and its V, for those who ask what arrives and not what is reflected. Under --visibility map
// the renderer puts map_point_on_light.glsl in the place of this file.
#include "surface/surface.glsl"
#include "integrator/random_point.glsl"
#include "integrator/rays.glsl"
#include "light/sample_light.glsl"
#include "visibility/visibility.glsl"

LightSample point_on_light(int k, Surface x) { return sample_light(k, x.position, random_point(uint(k) + 1u)); }

vec3 V_of_point(int k, Surface x, LightSample light) {
    return vec3(visibility(x, light.wi, light.distance, k, towards_light));
}
