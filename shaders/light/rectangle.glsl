// A rectangle of radiance L_e, sampled uniformly over its area A.
//
//   p(wi) = d² / (A cosθ_y)     [1/sr]
//
// The change of measure dω = cosθ_y dA / d² is Kajiya 1986's geometry term. Its front is cross(half_u, half_v).
// Limit: many points are spent in vain where d is small against the edges; u in [0, 1)².
#include "interface/lights.glsl"
#include "light/light_sample.glsl"

// The light that the point at `distance` in direction wi sends to x; none from its back.
LightSample rectangle_point(Light light, vec3 wi, float distance) {
    float cos_y = dot(light.direction, -wi);
    cos_y = light.is_two_sided ? abs(cos_y) : cos_y;
    if (cos_y <= 0.0) return no_light;
    float area = 4.0 * length(cross(light.half_u, light.half_v));
    float p = distance * distance / (area * cos_y);
    return LightSample(wi, distance, light.quantity / p, p);
}

LightSample sample_rectangle(Light light, vec3 x, vec2 u) {
    vec2 st = 2.0 * u - 1.0;
    vec3 to_light = light.position + st.x * light.half_u + st.y * light.half_v - x;
    float d = length(to_light);
    return rectangle_point(light, to_light / d, d);
}

// The rectangle as a ray from x meets it.
LightSample rectangle_along(Light light, vec3 x, vec3 wi) {
    float towards = dot(light.direction, wi);
    if (towards == 0.0) return no_light;
    vec3 to_center = light.position - x;
    float d = dot(light.direction, to_center) / towards;
    vec3 q = d * wi - to_center; // from the centre, in the rectangle's plane
    vec2 st = vec2(dot(q, light.half_u) / dot(light.half_u, light.half_u),
                   dot(q, light.half_v) / dot(light.half_v, light.half_v));
    if (d <= 0.0 || abs(st.x) > 1.0 || abs(st.y) > 1.0) return no_light;
    return rectangle_point(light, wi, d);
}
