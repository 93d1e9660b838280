// Given: the spectrum of a lamp, and the eye. Wavelengths are in nm.
#include "base/constants.glsl"

const float shortest = 380.0; // [nm] the visible range, as far as this assignment integrates
const float longest = 780.0;  // [nm]

// S(λ): the spectral power of a lamp [W/nm], a bell of this width (its standard deviation) around its peak.
// Its integral over all wavelengths is the power [W].
float S(float lambda, float power, float peak, float width) {
    float t = (lambda - peak) / width;
    return power / (width * sqrt(2.0 * pi)) * exp(-0.5 * t * t);
}

float bell(float lambda, float peak, float below, float above) {
    float t = (lambda - peak) * (lambda < peak ? below : above);
    return exp(-0.5 * t * t);
}

// x̄, ȳ, z̄ of the CIE 1931 observer, without unit (Wyman, Sloan & Shirley 2013, Eq. 4).
vec3 observer(float lambda) {
    return vec3(0.362 * bell(lambda, 442.0, 0.0624, 0.0374) + 1.056 * bell(lambda, 599.8, 0.0264, 0.0323)
                    - 0.065 * bell(lambda, 501.1, 0.0490, 0.0382),
                0.821 * bell(lambda, 568.8, 0.0213, 0.0247) + 0.286 * bell(lambda, 530.9, 0.0613, 0.0322),
                1.217 * bell(lambda, 437.0, 0.0845, 0.0278) + 0.681 * bell(lambda, 459.0, 0.0385, 0.0725));
}
