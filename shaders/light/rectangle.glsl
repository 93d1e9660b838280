// A rectangle of radiance L_e, sampled uniformly over its area A.
//
//   L_e / p(wi),   p(wi) = d² / (A cosθ_y)     [1/sr]
//
// The change of measure dω = cosθ_y dA / d² is Kajiya 1986's geometry term. Its front is cross(half_u, half_v).
// Limit: noisy where d is small against the edges; u in [0, 1)².
#include "interface/lights.glsl"
#include "light/light_sample.glsl"

LightSample sample_rectangle(Light light, vec3 x, vec2 u) {
    vec2 st = 2.0 * u - 1.0;
    vec3 to_light = light.position + st.x * light.half_u + st.y * light.half_v - x;
    float d2 = dot(to_light, to_light);
    float d = sqrt(d2);
    vec3 wi = to_light / d;
    float cos_y = dot(light.direction, -wi);
    cos_y = light.is_two_sided ? abs(cos_y) : max(cos_y, 0.0);
    float area = 4.0 * length(cross(light.half_u, light.half_v));
    return LightSample(wi, d, light.quantity * (area * cos_y / d2));
}
