// Emitters without extent: their light arrives from exactly one direction.
//
//   point        I / d² · window(d)
//   spot         I / d² · window(d) · saturate((cosθ - cos outer) / (cos inner - cos outer))²
//   directional  E
//
// KHR_lights_punctual. The window that `range` asks for is saturate(1 - (d / range)⁴) (Karis 2013, without the square,
// as the extension has it). A point's I may come from a photometric profile.
#include "interface/lights.glsl"
#include "light/light_sample.glsl"
#include "light/profile.glsl"

float range_window(float d, float inverse_range) {
    float q = d * inverse_range;
    float q2 = q * q;
    return clamp(1.0 - q2 * q2, 0.0, 1.0);
}

// w leaves the light; 1 for lights without a cone.
float cone_falloff(Light light, vec3 w) {
    float f = clamp(dot(light.direction, w) * light.cone_scale + light.cone_offset, 0.0, 1.0);
    return f * f;
}

LightSample sample_point(Light light, vec3 x) {
    vec3 to_light = light.position - x;
    float d2 = dot(to_light, to_light);
    float d = sqrt(d2);
    vec3 wi = to_light / d;
    if (!(d2 > 0.0)) return no_light; // x is where the light is
    vec3 E = light.quantity * profile_intensity(light, -wi) / d2;
    return LightSample(wi, d, min(E, vec3(max_irradiance)) * range_window(d, light.inverse_range), 0.0);
}

LightSample sample_spot(Light light, vec3 x) {
    LightSample s = sample_point(light, x);
    s.Li_over_p *= cone_falloff(light, -s.wi);
    return s;
}

LightSample sample_directional(Light light) {
    return LightSample(-light.direction, infinitely_far, min(light.quantity, vec3(max_irradiance)), 0.0);
}
