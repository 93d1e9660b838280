#pragma once
// From the angles that an IES file lists to a profile of all directions.
#include "scene/profile.hpp"

#include <optional>

namespace sr::scene {

/// The candela values of a file with all factors, in degrees.
struct IesGrid {
    std::vector<double> vertical;   // ascending, two or more
    std::vector<double> horizontal; // ascending, one or more
    std::vector<double> I;          // [cd]: a column of vertical.size() values for each horizontal angle

    double at(std::size_t v, std::size_t h) const { return I[h * vertical.size() + v]; }
};

/// Type C: vertical 0–180 from photometric zero, horizontal around it. Absent where the horizontal angles end
/// at none of the symmetries.
std::optional<LightProfile> profile_of_type_c(const IesGrid& grid);

/// Type B: planes that share the horizontal axis X. A direction is sinV X + cosV (cosH zero - sinH Y), where
/// X, Y and -zero are right-handed (LM-63-2002, section 3, counts H clockwise). What lies beyond the angles
/// is dark; angles from 0 only are completed by symmetry.
LightProfile profile_of_type_b(const IesGrid& grid);

} // namespace sr::scene
