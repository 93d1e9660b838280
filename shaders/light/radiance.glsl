// L_e of an emitter with an outline, in the direction wi in which x sees it, over its `quantity`.
#include "interface/features.glsl"
#include "light/emission_map.glsl"
#include "light/punctual.glsl"

vec3 radiance_of(Light light, vec3 x, vec3 wi) {
    if (light.kind == sphere_light) // points and spots with a radius, too: as sphere.glsl has it
        return vec3(profile_intensity(light, -wi) * cone_falloff(light, -wi)
                    * range_window(length(light.position - x), light.inverse_range));
    if (!has_emission_maps || light.map < 0) return vec3(1.0);
    vec3 to_center = light.position - x;
    vec3 q = dot(light.direction, to_center) / dot(light.direction, wi) * wi - to_center; // in the emitter's plane
    return emission_at(light, vec2(dot(q, light.half_u) / dot(light.half_u, light.half_u),
                                   dot(q, light.half_v) / dot(light.half_v, light.half_v)));
}

// A mesh's triangle (its first texel) has texture coordinates at its corners: read at the barycentric coordinates of
// the point that wi meets (Möller & Trumbore 1997, Eq. 6).
vec3 triangle_radiance(Light light, int texel, vec3 x, vec3 wi) {
    if (!has_emission_maps || light.map < 0) return vec3(1.0);
    vec3 a = texelFetch(light_table, texel).xyz;
    vec3 ab = texelFetch(light_table, texel + 1).xyz - a;
    vec3 ac = texelFetch(light_table, texel + 2).xyz - a;
    vec3 p = cross(wi, ac);
    vec3 q = cross(x - a, ab);
    float determinant = dot(ab, p);
    vec4 uv_ab = texelFetch(light_table, texel + 3);
    vec2 uv_c = texelFetch(light_table, texel + 4).xy;
    float s = dot(x - a, p) / determinant;
    float t = dot(wi, q) / determinant;
    return emission_map(light.map, (1.0 - s - t) * uv_ab.xy + s * uv_ab.zw + t * uv_c);
}
