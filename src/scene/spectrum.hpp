#pragma once
// Spectra, their colour and how bright a watt of them is.
#include "core/math.hpp"

#include <vector>

namespace sr::scene {

struct SpectrumPoint {
    double wavelength = 0.0; // [nm]
    double value = 0.0;      // power per wavelength, in any scale
};

/// Linear between its points, of ascending wavelength, and nothing outside them.
using Spectrum = std::vector<SpectrumPoint>;

/// The colour and efficacy of a spectrum's light. The stated quantity times rgb is its RGB.
struct LightColor {
    vec3 rgb{1.0f};          // linear Rec. 709, of luminance 1
    double efficacy = 683.0; // K [lm/W]; lumens_per_watt where no spectrum is known
};

/// The largest luminous efficacy, at 540 THz [lm/W]: SI Brochure, 9th edition, section 2.3.1, K_cd. What a
/// watt counts where no spectrum says otherwise.
inline constexpr double lumens_per_watt = 683.0;

/// XYZ to linear Rec. 709 with D65: IEC 61966-2-1.
glm::dvec3 rgb_of_xyz(glm::dvec3 xyz);

/// Returns the luminance in double precision.
inline double luminance(vec3 rgb) { return sr::luminance(glm::dvec3(rgb)); }

/// ∫ S(λ) (x̄, ȳ, z̄) dλ, exact for what is linear between points.
glm::dvec3 xyz_of(const Spectrum& spectrum);

/// A colour of the same hue and luminance 1. Components below zero, colours that Rec. 709 cannot show, become
/// zero first. White for black.
vec3 with_unit_luminance(glm::dvec3 rgb);

/// K = 683 ∫ S ȳ dλ / ∫ S dλ, and the colour through the 1931 observer.
LightColor color_of(const Spectrum& spectrum);

/// A black body's (Planck 1901): the colour by its visible part, K by all of its radiation, σT⁴.
LightColor color_of_blackbody(double temperature /* [K] */);

/// Spectral radiant exitance of a black body [W/m³] (Planck's law with the constants of the SI of 2019).
double planck(double wavelength /* [nm] */, double temperature /* [K] */);

} // namespace sr::scene
