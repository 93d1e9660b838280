// A disk or an ellipse of radiance L_e, sampled along the radii that it shows.
//
//   p(wi) = |b| (|b| + o·b) / (2π o·(half_u × half_v))          [1/sr]
//
// o is the unit direction to the centre c, b(t) = c + half_u cos t + half_v sin t the rim. t is uniform, and on the arc
// from o to b the height 1 - cosψ is, so that dω = (1 - cosψ_b) dφ/dt dt du, where dφ/dt = o·(b × b') / |o × b|².
// For an ellipse o·(b × b') = o·(half_u × half_v) at every t and 1 - cosψ_b = |o × b|² / (|b| (|b| + o·b)), which
// leaves the density above: no term cancels, and a distant disk's is uniform.
#include "base/constants.glsl"
#include "light/emission_map.glsl"
#include "light/flat.glsl"
#include "light/light_sample.glsl"

float p_disk(Light light, vec3 to_center, vec2 rim) {
    vec3 b = to_center + rim.x * light.half_u + rim.y * light.half_v;
    vec3 o = normalize(to_center);
    float r = length(b);
    return r * (r + dot(o, b)) / (2.0 * pi * abs(dot(o, cross(light.half_u, light.half_v))));
}

LightSample sample_disk(Light light, vec3 x, vec2 u) {
    vec3 to_center = light.position - x;
    if (!faces(light, x, to_center)) return no_light;
    vec2 rim = vec2(cos(2.0 * pi * u.x), sin(2.0 * pi * u.x));
    vec3 e = rim.x * light.half_u + rim.y * light.half_v;
    vec3 b = to_center + e;
    vec3 o = normalize(to_center);
    vec3 across = e - dot(o, e) * o;
    float r = length(b);
    float height = u.y * dot(across, across) / (r * (r + dot(o, b))); // 1 - cosψ
    vec3 wi = normalize((1.0 - height) * o + sqrt(height * (2.0 - height)) * normalize(across));
    float d = distance_to_plane(light, to_center, wi);
    if (!(d > 0.0)) return no_light; // alongside, but for rounding
    vec2 st = plane_coordinates(light, d * wi - to_center);
    return light_sample(wi, d, light.quantity * emission_at(light, st), p_disk(light, to_center, rim));
}

LightSample disk_along(Light light, vec3 x, vec3 wi) {
    vec3 to_center = light.position - x;
    float d = distance_to_plane(light, to_center, wi);
    vec2 st = plane_coordinates(light, d * wi - to_center);
    float q2 = dot(st, st);
    if (!(d > 0.0 && q2 <= 1.0) || !faces(light, x, to_center)) return no_light;
    vec2 rim = q2 > 0.0 ? st * inversesqrt(q2) : vec2(1.0, 0.0);
    return light_sample(wi, d, light.quantity * emission_at(light, st), p_disk(light, to_center, rim));
}
