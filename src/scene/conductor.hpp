#pragma once
// Metals by their measured complex index of refraction.
#include "scene/material.hpp"
#include "scene/spectrum.hpp"

#include <functional>
#include <optional>
#include <string_view>
#include <vector>

namespace sr::scene {

/// n + ik at a wavelength.
struct IorPoint {
    double wavelength = 0.0; // [nm]
    double n = 0.0;
    double k = 0.0;
};

/// Linear between its points, of ascending wavelength, and constant beyond them.
using IorSpectrum = std::vector<IorPoint>;

/// The measured spectrum of a metal; absent for another name. Sources: conductor.cpp.
std::optional<IorSpectrum> measured_metal(std::string_view name);
/// "aluminium", "chromium", …
std::vector<std::string_view> metal_names();

/// The unpolarised reflectance of a smooth conductor at cosθ (Born & Wolf 1999, section 14.2).
double fresnel_conductor(double cos_theta, double n, double k);

/// Returns the reflectance of a smooth surface at cosθ, as linear Rec. 709: RGB(S R) / RGB(S) through the
/// 1931 observer, S being a black body of 6504 K (white, D65's colour temperature), no more than 1.
glm::dvec3 reflectance_of(const IorSpectrum& spectrum, double cos_theta);

/// The n + ik for each channel whose reflectance comes nearest to reflectance_of over all angles (least
/// squares over 16 cosines).
ComplexIor fit_ior(const IorSpectrum& spectrum);

} // namespace sr::scene
