#pragma once
// Lines of equal value through a grid of numbers.
#include "core/math.hpp"

#include <functional>
#include <vector>

namespace sr::output {

/// A line of equal value, in cells: (0, 0) is the centre of the grid's first cell.
using Isoline = std::vector<vec2>;

/// The lines on which a grid of columns × rows numbers has the value `level`, linear between neighbouring
/// centres. A closed line ends where it begins; others end at the grid's border. A square whose corners are
/// high and low by turns is cut by the mean of its corners. Source: Maple, "Geometric Design and Space
/// Planning Using the Marching Squares and Marching Cube Algorithms", GMAG 2003.
/// @param value of (column, row)
std::vector<Isoline> isolines(int columns, int rows, const std::function<double(int, int)>& value,
                              double level);

/// Round levels between `min` and `max`, steps of 1, 2 or 5 times a power of ten: at most `count`, and none
/// where min and max are equal.
std::vector<double> round_levels(double min, double max, int count);

} // namespace sr::output
