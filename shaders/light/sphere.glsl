// A sphere of radiance L_e, sampled uniformly over the cone in which it is seen.
//
//   sinσ = r / d,   p(wi) = 1 / (2π (1 - cosσ))      [1/sr]
//
// Shirley, Wang & Zimmerman 1996, section 3.2. A point or spot that has a radius is a sphere whose radiance is
// I(w) / (π r²) in the direction w, so that it has the intensity I. From within nothing is seen: it emits outwards.
#include "interface/lights.glsl"
#include "light/cone.glsl"
#include "light/light_sample.glsl"
#include "light/punctual.glsl"

// The sphere in direction wi, which meets it.
LightSample sphere_point(Light light, vec3 to_center, vec3 wi, float p) {
    float middle = dot(wi, to_center);
    vec3 off = to_center - middle * wi;
    float distance = middle - sqrt(max(light.radius * light.radius - dot(off, off), 0.0));
    vec3 L_e = light.quantity * profile_intensity(light, -wi) * cone_falloff(light, -wi)
             * range_window(length(to_center), light.inverse_range);
    return light_sample(wi, distance, L_e, p);
}

LightSample sample_sphere(Light light, vec3 x, vec2 u) {
    vec3 to_center = light.position - x;
    float sin2 = light.radius * light.radius / dot(to_center, to_center);
    if (!(sin2 < 1.0)) return no_light;
    float height = one_minus_cos(sin2);
    return sphere_point(light, to_center, sample_cone(normalize(to_center), height, u), p_cone(height));
}

LightSample sphere_along(Light light, vec3 x, vec3 wi) {
    vec3 to_center = light.position - x;
    float d2 = dot(to_center, to_center);
    float r2 = light.radius * light.radius;
    float middle = dot(wi, to_center);
    vec3 off = to_center - middle * wi;
    if (!(r2 < d2 && middle > 0.0 && dot(off, off) <= r2)) return no_light;
    return sphere_point(light, to_center, wi, p_cone(one_minus_cos(r2 / d2)));
}
