// A disk in the sky, infinitely far: directional light with an angular radius σ.
//
//   L_e = E / (π sin²σ),   p(wi) = 1 / (2π (1 - cosσ))      [1/sr]
//
// L_e gives E on a surface that faces the disk's centre: ∫ cosθ dω over the cone is π sin²σ.
#include "interface/lights.glsl"
#include "light/cone.glsl"
#include "light/light_sample.glsl"

vec3 sun_radiance(Light light) {
    float s = sin(light.radius);
    return light.quantity / (pi * s * s);
}

float sun_height(Light light) { // 1 - cosσ
    float s = sin(0.5 * light.radius);
    return 2.0 * s * s;
}

LightSample sample_sun(Light light, vec2 u) {
    float height = sun_height(light);
    return light_sample(sample_cone(-light.direction, height, u), infinitely_far, sun_radiance(light), p_cone(height));
}

LightSample sun_along(Light light, vec3 wi) {
    vec3 off = wi + light.direction; // from the centre of the disk: a chord of length 2 sin(θ/2)
    float height = sun_height(light);
    if (!(dot(off, off) <= 2.0 * height)) return no_light;
    return light_sample(wi, infinitely_far, sun_radiance(light), p_cone(height));
}
