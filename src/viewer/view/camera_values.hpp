#pragma once
// Values of a camera as a person types and reads them: "1.2, 0, 350 cm", "40 deg", "50 mm".
#include "core/math.hpp"

#include <string>
#include <string_view>

namespace sr::viewer {

/// Reads a point of three numbers, separated by commas or blanks, each or all followed by m, cm, mm, km, ft
/// or in; without a unit in metres. @throws Error that says what a point is
glm::dvec3 parse_point(std::string_view text);

/// Reads one length as a number of a point. @throws Error
double parse_length(std::string_view text);

/// Reads a full vertical angle [rad]: a number of degrees, with deg or ° if wanted, or one with rad. A number
/// with mm is the focal length of a lens before film that is 24 mm high. @throws Error, also unless it is
/// between 0 and 180 degrees
double parse_field_of_view(std::string_view text);

/// "1.2, 0, 3.5 m", "1.2 m", "40 deg", with as many digits as a float has.
std::string text_of_point(glm::dvec3 point);
std::string text_of_length(double length);
std::string text_of_field_of_view(double angle);

} // namespace sr::viewer
