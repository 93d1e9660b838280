#pragma once
// Measured isotropic BRDFs in the binary format of the MERL database.
//
// Matusik, Pfister, Brand & McMillan 2003, "A data-driven reflectance model": f_r over the half angle θh, the
// difference angle θd and φd (Rusinkiewicz 1998), 90 × 90 × 180 cells; θh is denser near the peak.
#include "core/math.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace sr::scene {

inline constexpr int merl_half_angles = 90;       // θh = (π/2) (i / 90)²
inline constexpr int merl_difference_angles = 90; // θd = (π/2) i / 90
inline constexpr int merl_azimuths = 180;         // φd = π i / 180
inline constexpr std::size_t merl_cells =
    std::size_t{merl_half_angles} * merl_difference_angles * merl_azimuths;

struct MeasuredBrdf {
    std::string name;
    /// f_r [1/sr] at the middle of cell (θh, θd, φd), φd running fastest; merl_cells of them, none negative.
    std::vector<vec3> values;
    /// Width of the GGX lobe that falls to half of its height (above what lies around it) where the measured
    /// one does; what it is sampled by.
    float alpha = 1.0f;
};

/// wi and wo at the middle of a cell of MeasuredBrdf::values, in a frame where z is the normal.
std::pair<vec3, vec3> merl_directions(std::size_t cell);

/// Reads a file of the database: three 32-bit counts, then all of red, green and blue as 64-bit floats, to be
/// scaled by 1/1500, 1.15/1500 and 1.66/1500. Cells without a measurement (negative) become 0.
/// @throws Error calling it `name`, if its size is another or a value is not finite
MeasuredBrdf read_merl(std::span<const std::byte> file, const std::string& name);

/// The same file for values in the order of MeasuredBrdf::values.
std::vector<std::byte> merl_file(std::span<const vec3> values);

} // namespace sr::scene
