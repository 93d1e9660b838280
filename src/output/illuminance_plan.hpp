#pragma once
// A plan of a receiver: illuminance in false colours, with isolines.
#include "output/illuminance.hpp"

#include <string>
#include <vector>

namespace sr::output {

/// A mark at a place of the receiver, such as a lamp above it.
struct PlanMark {
    vec2 place{0.0f}; // along u and v, 0 to 1
    std::string name;
};

/// An SVG picture: a square a cell on a linear scale from 0 to the greatest value, isolines with their
/// values, a scale in metres along both edges, a legend, marks, and `title` above. It needs nothing from
/// outside.
/// @param levels of the isolines
std::string plan_svg(const IlluminanceGrid& grid, const std::vector<double>& levels,
                     const std::vector<PlanMark>& marks, const std::string& title);

} // namespace sr::output
