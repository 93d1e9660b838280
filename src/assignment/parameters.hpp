#pragma once
// Parameters: numbers that differ between students.
#include "assignment/manifest.hpp"

#include <map>
#include <string>

namespace sr::assignment {

using Parameters = std::map<std::string, double>;

/// The numbers of a student: equal for the same assignment and id, on every machine.
Parameters parameters_of(const Assignment& assignment, const std::string& student);

/// The parameters as GLSL constants, for the file parameters.glsl.
std::string parameters_glsl(const Assignment& assignment, const Parameters& parameters);

/// Replaces each {{name}} by its number. `place` is what errors call the text.
/// @throws Error with the line for a name that is no parameter
std::string substituted(const std::string& text, const Parameters& parameters, const std::string& place);

/// The same for JSON, where a number is written as the text "{{name}}".
std::string substituted_json(std::string text, const Parameters& parameters, const std::string& place);

} // namespace sr::assignment
