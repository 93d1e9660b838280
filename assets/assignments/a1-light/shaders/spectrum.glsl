// A1.1 to A1.3: photons, and from a spectrum to a colour. Wavelengths are in nm.
#include "assignment/not_implemented.glsl"
#include "observer.glsl"
#include "parameters.glsl"

const float planck = 6.62607015e-34;   // h [J s]
const float light_speed = 299792458.0; // c [m/s]
const float metres_per_nm = 1e-9;

// begin solution A1.1
// E = h c / λ: the energy of one photon                                                [J]
float photon_energy(float lambda) { return planck * light_speed / (lambda * metres_per_nm); }

// Φ λ / (h c): how many photons a source of one wavelength and of Φ watts sends in a second   [1/s]
float photons_per_second(float Phi, float lambda) { return Phi / photon_energy(lambda); }

// The same for your laser: laser_power [W] and laser_wavelength [nm] stand in parameters.glsl.
float photons_of_your_laser() { return photons_per_second(laser_power, laser_wavelength); }
// end

// begin solution A1.2
// (X, Y, Z) = ∫ S(λ) (x̄, ȳ, z̄)(λ) dλ from `shortest` to `longest`                       [W]
//
// A sum of 80 steps of 5 nm is near enough. Call S and observer.
vec3 XYZ_of_lamp(float power, float peak, float width) {
    const int steps = 80;
    float d_lambda = (longest - shortest) / float(steps);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < steps; ++i) {
        float lambda = shortest + (float(i) + 0.5) * d_lambda;
        sum += S(lambda, power, peak, width) * observer(lambda) * d_lambda;
    }
    return sum;
}

// Φ_v = 683 Y: the luminous flux of light with these X, Y, Z                           [lm]
float luminous_flux(vec3 XYZ) { return 683.0 * XYZ.y; }
// end

// begin solution A1.3
// Linear RGB of X, Y, Z. The matrix, row by row:
//
//   R =  3.2404542 X - 1.5371385 Y - 0.4985314 Z
//   G = -0.9692660 X + 1.8760108 Y + 0.0415560 Z
//   B =  0.0556434 X - 0.2040259 Y + 1.0572252 Z
//
// Values below 0 stay: they say that a screen cannot show this colour.
vec3 RGB_of_XYZ(vec3 XYZ) {
    const mat3 rows = mat3(3.2404542, -1.5371385, -0.4985314, -0.9692660, 1.8760108, 0.0415560, 0.0556434,
                           -0.2040259, 1.0572252);
    return XYZ * rows;
}

// And back: the inverse of that matrix.
vec3 XYZ_of_RGB(vec3 RGB) {
    const mat3 rows = mat3(0.4124564, 0.3575761, 0.1804375, 0.2126729, 0.7151522, 0.0721750, 0.0193339,
                           0.1191920, 0.9503041);
    return RGB * rows;
}

// Linear RGB of your lamp over its Y: lamp_power, lamp_peak and lamp_width stand in parameters.glsl.
vec3 RGB_of_your_lamp() {
    vec3 XYZ = XYZ_of_lamp(lamp_power, lamp_peak, lamp_width);
    return RGB_of_XYZ(XYZ) / XYZ.y;
}
// end
