#pragma once
// The CIE 1931 standard observer: how much of each wavelength an eye counts.
#include "core/math.hpp"

namespace sr::scene {

inline constexpr double first_wavelength = 360.0; // [nm]
inline constexpr double last_wavelength = 830.0;  // [nm]
inline constexpr double observer_step = 5.0;      // [nm]

/// (x̄, ȳ, z̄) of the 2° observer at a wavelength [nm], linear between the table's rows, zero outside them.
/// ȳ is V(λ), the photopic luminous efficiency (CIE 15:2004, section 7.1).
glm::dvec3 observer(double wavelength);

} // namespace sr::scene
