// The emissive triangle that a direction meets first, by trying all of them: for mirrors, which nothing else shows a mesh.
//
// Intersection: Möller & Trumbore 1997. Limit: the cost is that of the mesh's triangles.
#include "light/mesh.glsl"

// p = 1 where it is met: Li_over_p is L_e.
LightSample mesh_along(Light light, vec3 x, vec3 wi) {
    LightSample nearest = no_light;
    for (int i = 0; i < light.count; ++i) {
        int first = light.data + texels_per_triangle * i;
        vec3 a = texelFetch(light_table, first).xyz - x;
        vec3 ab = texelFetch(light_table, first + 1).xyz - x - a;
        vec3 ac = texelFetch(light_table, first + 2).xyz - x - a;
        vec3 normal = cross(ab, ac);
        if (!shines_on(normal, x, a, light.is_two_sided)) continue;
        float facing = dot(normal, wi); // negative: its front
        float d = dot(normal, a) / facing;
        vec2 at = vec2(dot(wi, cross(ac, a)), dot(wi, cross(a, ab))) / facing;
        if (!(d > 0.0 && d < nearest.distance && at.x >= 0.0 && at.y >= 0.0 && at.x + at.y <= 1.0)) continue;
        vec3 L_e = light.quantity;
        if (has_emission_maps && light.map >= 0) {
            vec4 uv_ab = texelFetch(light_table, first + 3);
            vec2 uv_c = texelFetch(light_table, first + 4).xy;
            L_e *= emission_map(light.map, uv_ab.xy + at.x * (uv_ab.zw - uv_ab.xy) + at.y * (uv_c - uv_ab.xy));
        }
        nearest = LightSample(wi, d, L_e, 1.0);
    }
    return nearest;
}
