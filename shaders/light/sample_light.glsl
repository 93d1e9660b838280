// Light k as it arrives at x.
#include "interface/features.glsl"
#include "light/disk.glsl"
#include "light/environment.glsl"
#include "light/mesh.glsl"
#include "light/polygon.glsl"
#include "light/punctual.glsl"
#include "light/rectangle.glsl"
#include "light/sphere.glsl"
#include "light/sun.glsl"
#include "light/tube_along.glsl"

// Emitters that a direction of the BRDF's choice can meet.
const bool has_lights_to_meet = has_rectangle_lights || has_disk_lights || has_sphere_lights || has_tube_lights
                             || has_polygon_lights || has_sun_disks || has_environment_lights;
const bool has_area_lights = has_lights_to_meet || has_mesh_lights;

// Returns whether a direction of the BRDF's choice can meet a light of this kind, or of an unknown one.
bool is_met(int kind) {
    return kind == directional_light ? has_sun_disks : kind != point_light && kind != spot_light && kind != mesh_light;
}

// In a direction of the light's choice; emitters without extent ignore the random numbers u.
LightSample sample_light(Light light, vec3 x, vec2 u) {
    if (has_rectangle_lights && light.kind == rectangle_light) return sample_rectangle(light, x, u);
    if (has_disk_lights && light.kind == disk_light) return sample_disk(light, x, u);
    if (has_sphere_lights && light.kind == sphere_light) return sample_sphere(light, x, u);
    if (has_tube_lights && light.kind == tube_light) return sample_tube(light, x, u);
    if (has_polygon_lights && light.kind == polygon_light) return sample_polygon(light, x, u);
    if (has_mesh_lights && light.kind == mesh_light) return sample_mesh(light, x, u);
    if (has_environment_lights && light.kind == environment_light) return sample_environment(light, u);
    if (has_spot_lights && light.kind == spot_light) return sample_spot(light, x);
    if (has_sun_disks && light.kind == directional_light && light.radius > 0.0) return sample_sun(light, u);
    if (has_directional_lights && light.kind == directional_light) return sample_directional(light);
    return sample_point(light, x);
}

// In the direction wi: p = 0 where the light is not met.
LightSample light_along(Light light, vec3 x, vec3 wi) {
    if (has_rectangle_lights && light.kind == rectangle_light) return rectangle_along(light, x, wi);
    if (has_disk_lights && light.kind == disk_light) return disk_along(light, x, wi);
    if (has_sphere_lights && light.kind == sphere_light) return sphere_along(light, x, wi);
    if (has_tube_lights && light.kind == tube_light) return tube_along(light, x, wi);
    if (has_polygon_lights && light.kind == polygon_light) return polygon_along(light, x, wi);
    if (has_sun_disks && light.kind == directional_light && light.radius > 0.0) return sun_along(light, wi);
    if (has_environment_lights && light.kind == environment_light) return environment_along(light, wi);
    return no_light;
}

LightSample sample_light(int k, vec3 x, vec2 u) { return sample_light(light_at(k), x, u); }
LightSample light_along(int k, vec3 x, vec3 wi) { return light_along(light_at(k), x, wi); }
