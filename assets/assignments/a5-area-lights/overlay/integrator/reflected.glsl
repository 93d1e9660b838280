// The renderer's L_r: the student's estimators, times the base colour and V(x, y).
#include "assignment/not_implemented.glsl"
#include "estimator.glsl"
#include "sphere.glsl"
#include "integrator/random_point.glsl"
#include "integrator/rays.glsl"
#include "interface/lights.glsl"
#include "surface/surface.glsl"
#include "visibility/visibility.glsl"

Rectangle rectangle_of(Light light) {
    vec3 u = 2.0 * light.half_u, v = 2.0 * light.half_v;
    if (dot(cross(u, v), light.direction) < 0.0) return Rectangle(light.position - 0.5 * (u + v), v, u);
    return Rectangle(light.position - 0.5 * (u + v), u, v);
}

vec3 from_rectangle(Light light, int k, Surface x, vec2 u) {
    Rectangle r = rectangle_of(light);
    vec3 d = point_on(r, u) - x.position;
    float L_r = L_r_of_sample(r, 1.0, x.position, x.n, 1.0, u);
    return L_r * light.quantity * visibility(x, normalize(d), length(d), k, towards_light);
}

vec3 from_sphere(Light light, int k, Surface x, vec2 u) {
    vec3 wi = direction_in_cone(x.position, light.position, light.radius, u);
    float cos_i = dot(x.n, wi);
    if (!(cos_i > 0.0)) return vec3(0.0);
    float d = dot(light.position - x.position, wi); // the sphere does not shadow itself
    float L_r_over_L_e = cos_i / (pi * p_cone(x.position, light.position, light.radius));
    return L_r_over_L_e * light.quantity * visibility(x, wi, d, k, towards_light);
}

vec3 reflected(Surface x, vec3 wo) {
    vec3 L_r = vec3(0.0);
    for (int k = first_light; k < end_light; ++k) {
        Light light = light_at(k);
        vec2 u = random_point(uint(k) + 1u);
        if (light.kind == rectangle_light) L_r += from_rectangle(light, k, x, u);
        if (light.kind == sphere_light) L_r += from_sphere(light, k, x, u);
    }
    if (not_implemented_calls > 0) return vec3(100.0, 0.0, 100.0); // magenta [cd/m²]
    return x.base_color * L_r;
}
