// A flat convex polygon of radiance L_e, sampled uniformly over the solid angle Ω in which it is seen.
//
//   p(wi) = 1 / Ω                                              [1/sr]
//
// A fan of spherical triangles around the first corner; one is chosen by its share of Ω.
#include "interface/lights.glsl"
#include "light/flat.glsl"
#include "light/light_sample.glsl"
#include "light/triangle.glsl"

vec3 polygon_corner(Light light, int i, vec3 x) { return texelFetch(light_table, light.data + i).xyz - x; }

// Ω of the fan's triangle between corners i and i + 1.
float fan_solid_angle(Light light, int i, vec3 x) {
    vec3 a = polygon_corner(light, 0, x);
    vec3 b = polygon_corner(light, i, x);
    vec3 c = polygon_corner(light, i + 1, x);
    return triangle_solid_angle(a, b, c, cross(b - a, c - a));
}

float polygon_solid_angle(Light light, vec3 x) {
    float sum = 0.0;
    for (int i = 1; i + 1 < light.count; ++i) sum += fan_solid_angle(light, i, x);
    return sum;
}

LightSample polygon_point(Light light, vec3 to_center, vec3 wi, float solid_angle) {
    float d = distance_to_plane(light, to_center, wi);
    if (!(solid_angle > 0.0)) return no_light;
    return light_sample(wi, d, light.quantity, 1.0 / solid_angle);
}

LightSample sample_polygon(Light light, vec3 x, vec2 u) {
    vec3 to_center = light.position - x;
    if (!faces(light, x, to_center)) return no_light;
    float total = polygon_solid_angle(light, x);
    float rest = u.x * total;
    float share = 0.0;
    int chosen = 0;
    while (chosen + 2 < light.count) {
        share = fan_solid_angle(light, ++chosen, x);
        if (rest < share) break;
        if (chosen + 2 < light.count) rest -= share;
    }
    if (!(share > 0.0)) return no_light; // x in the polygon's plane
    vec3 wi = sample_spherical_triangle(polygon_corner(light, 0, x), polygon_corner(light, chosen, x),
                                        polygon_corner(light, chosen + 1, x), share,
                                        vec2(clamp(rest / share, 0.0, 1.0), u.y));
    return polygon_point(light, to_center, wi, total);
}

LightSample polygon_along(Light light, vec3 x, vec3 wi) {
    vec3 to_center = light.position - x;
    if (!faces(light, x, to_center) || !(dot(light.direction, wi) * dot(light.direction, to_center) > 0.0)) return no_light;
    float side = sign(dot(light.direction, wi)); // seen from the back the corners go round the other way
    vec3 a = polygon_corner(light, light.count - 1, x);
    for (int i = 0; i < light.count; ++i) {
        vec3 b = polygon_corner(light, i, x);
        if (side * dot(wi, cross(a, b)) < 0.0) return no_light;
        a = b;
    }
    return polygon_point(light, to_center, wi, polygon_solid_angle(light, x));
}
