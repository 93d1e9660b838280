// A2.4 to A2.6: from irradiance to radiance, with units kept to the pixel.
#include "assignment/not_implemented.glsl"
#include "base/constants.glsl"
#include "parameters.glsl"

// begin solution A2.4
// f_r = ρ / π: the BRDF of a matt surface of albedo ρ                                  [1/sr]
vec3 f_diffuse(vec3 rho) { return rho / pi; }

// L_r = f_r E: the radiance that it reflects, the same in all directions               [cd/m²]
vec3 L_r(vec3 rho, vec3 E) { return f_diffuse(rho) * E; }

// M = ∫ L cosθ dω = π L: all that a surface sends out that has radiance L in all directions    [lm/m²]
vec3 exitance(vec3 L) { return pi * L; }
// end

// begin solution A2.5
// I of a point that sends Φ [lm] evenly in all directions                              [cd]
float intensity_of_point(float Phi) { return Phi / (4.0 * pi); }

// I of a lamp that sends Φ [lm] evenly into a cone; alpha is the angle from its axis to its edge [rad]   [cd]
float intensity_of_cone(float Phi, float alpha) { return Phi / (2.0 * pi * (1.0 - cos(alpha))); }

// L of a matt panel of area A [m²] that sends Φ [lm] to its front, with the same L in all directions    [cd/m²]
float radiance_of_panel(float Phi, float A) { return Phi / (pi * A); }

// L_r of your wall, of albedo wall_albedo, whose nearest point to your bulb is bulb_distance [m] away. The bulb
// sends bulb_flux [lm] evenly in all directions. Take that nearest point.              [cd/m²]
float radiance_of_your_wall() {
    float E = intensity_of_point(bulb_flux) / (bulb_distance * bulb_distance);
    return wall_albedo / pi * E;
}
// end

// begin solution A2.6
// L / (1.2 · 2^EV100): the share of the brightest value that a camera of this exposure shows   [1]
vec3 exposed(vec3 L, float EV100) { return L / (1.2 * exp2(EV100)); }

// The sRGB value of a linear one, channel by channel. Values outside 0 to 1 are cut off first:
// 12.92 v up to 0.0031308, else 1.055 v^(1/2.4) - 0.055                                [1]
vec3 encoded(vec3 v) {
    v = clamp(v, 0.0, 1.0);
    return mix(1.055 * pow(max(v, 0.0031308), vec3(1.0 / 2.4)) - 0.055, 12.92 * v, lessThanEqual(v, vec3(0.0031308)));
}

// And back, for values from 0 to 1.
vec3 decoded(vec3 s) {
    return mix(pow((max(s, 0.04045) + 0.055) / 1.055, vec3(2.4)), s / 12.92, lessThanEqual(s, vec3(0.04045)));
}

// What a file of 8 bits has for your wall at camera_EV, from 0 to 255, before rounding. [1]
float code_value_of_your_wall() { return 255.0 * encoded(exposed(vec3(radiance_of_your_wall()), camera_EV)).r; }
// end
