// The surface, the lamp and the sky of the assignment. Nothing is to be written here. Directions are unit and leave the surface.
#include "base/constants.glsl"
#include "base/frame_around.glsl"
#include "parameters.glsl"

// The BRDF: Phong's lobe around the mirrored wo, of the exponent m                      [1/sr]
float f_lobe(vec3 n, vec3 wi, vec3 wo, float m) {
    float cos_g = dot(reflect(-wo, n), wi);
    return cos_g > 0.0 ? (m + 2.0) / (2.0 * pi) * pow(cos_g, m) : 0.0;
}

// The lamp: round, of radiance 1 cd/m², seen within the angle lamp_angle around `axis`.
float L_lamp(vec3 axis, vec3 wi) { return dot(wi, axis) > cos(lamp_angle) - 1e-6 ? 1.0 : 0.0; }

// A direction to the lamp, uniform over its solid angle, and the density of such directions                [1, 1/sr]
vec3 lamp_direction(vec3 axis, vec2 u) {
    float z = 1.0 - u.x * (1.0 - cos(lamp_angle));
    float s = sqrt(max(0.0, 1.0 - z * z));
    return frame_around(axis) * vec3(s * cos(2.0 * pi * u.y), s * sin(2.0 * pi * u.y), z);
}

float lamp_density(vec3 axis, vec3 wi) { return L_lamp(axis, wi) / (2.0 * pi * (1.0 - cos(lamp_angle))); }

// L_r with n, wo and the lamp in one line, in closed form: 1 - cos^(m+2) of the lamp's angle                 [cd/m²]
float exact_L_r(float m) { return 1.0 - pow(cos(lamp_angle), m + 2.0); }

// An overcast sky, after Moon & Spencer 1942: brighter towards the zenith, +z                                [cd/m²]
float L_sky(vec3 w) { return (1.0 + 2.0 * w.z) / 3.0; }

// Its irradiance on a horizontal surface                                                                      [lx]
const float exact_E_sky = 7.0 / 9.0 * pi;

// Numbers in [0, 1)² that look random: pair i of the sequence of `seed`.
vec2 random_2d(float seed, int i) {
    uvec2 v = uvec2(floatBitsToUint(seed), uint(i) * 2654435769u + 1u);
    for (int k = 0; k < 4; ++k) {
        v = v * 1664525u + 1013904223u;
        v += v.yx * 1664525u;
        v ^= v >> 16u;
    }
    return vec2(v >> 8u) / 16777216.0;
}
