// The emitters that are evaluated by their outline: all of finite size, but meshes of more triangles than a pixel can
// afford.
#include "interface/estimator.glsl"
#include "interface/features.glsl"
#include "light/outline_round.glsl"
#include "light/radiance.glsl"
#include "light/sample_light.glsl"
#include "light/visible_outline.glsl"

// Number of outlines of a light; 0 if it is sampled.
int outlines_of(Light light) {
    if (!has_cones && !has_rectangle_lights && !has_polygon_lights && !has_mesh_lights) return 0;
    if (has_mesh_lights && light.kind == mesh_light)
        return light.count <= max_outlined_triangles ? light.count : 0;
    if (light.kind == directional_light) return has_sun_disks && light.radius > 0.0 ? 1 : 0;
    bool is_flat = light.kind == rectangle_light || light.kind == disk_light || light.kind == polygon_light;
    return is_flat || light.kind == sphere_light || light.kind == tube_light ? 1 : 0;
}

Outline outline_of(Light light, int part, vec3 x, mat3 warp) {
    if (has_rectangle_lights && light.kind == rectangle_light) return rectangle_outline(light, x, warp);
    if (has_polygon_lights && light.kind == polygon_light)
        return polygon_outline(light.data, light.count, light.direction, light.is_two_sided, x, warp);
    if (has_mesh_lights && light.kind == mesh_light)
        return triangle_outline(light.data + texels_per_triangle * part, light.is_two_sided, x, warp);
    if (has_cones) return round_outline(light, x, warp);
    return empty_outline(x, warp);
}

// L_e of that part, in the direction wi that lies within its outline.
vec3 radiance_towards(Light light, int part, vec3 x, vec3 wi) {
    if (has_sun_disks && light.kind == directional_light) { // E = L π sin²
        float s = sin(light.radius);
        return light.quantity / (pi * s * s);
    }
    if (has_mesh_lights && light.kind == mesh_light)
        return light.quantity * triangle_radiance(light, light.data + texels_per_triangle * part, x, wi);
    return light.quantity * radiance_of(light, x, wi);
}

const float far_away = 1e15; // where nothing is [m]

// Distance to that part in the direction wi [m].
float distance_along(int k, Light light, int part, vec3 x, vec3 wi) {
    if (!has_mesh_lights || light.kind != mesh_light) return light_along(k, x, wi).distance;
    int texel = light.data + texels_per_triangle * part;
    vec3 a = texelFetch(light_table, texel).xyz;
    vec3 normal = cross(texelFetch(light_table, texel + 1).xyz - a, texelFetch(light_table, texel + 2).xyz - a);
    float distance = dot(normal, a - x) / dot(normal, wi);
    return distance > 0.0 && distance < far_away ? distance : length(a - x); // edge-on, where rounding decides
}
