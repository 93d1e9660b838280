#pragma once
// The values of a GLSL expression over a table of inputs, with some regions of the reference replaced.
#include "assignment/inputs.hpp"
#include "assignment/parameters.hpp"

#include <map>
#include <string>
#include <vector>

namespace sr::assignment {

/// What stands in a region, and where people find it.
struct Code {
    std::string place;
    int line = 1; // of the text's first line, counted from 1
    std::string text;
};

/// What stands in regions in the place of the reference's code, by the region's name.
using Codes = std::map<std::string, Code>;

/// Where shaders come from: the codes, the reference around them, the assignment's overlay/, the program's
/// shaders.
std::vector<glsl::Root> shader_path(const Assignment& assignment, const Parameters& parameters,
                                    const Codes& codes);

/// An expression and its GLSL type, float to vec4, bool or int.
struct Expression {
    std::string text;
    std::string type;
};

/// How many numbers the type has.
int components_of(const std::string& type);

struct Values {
    std::vector<glm::dvec4> means; // of each group of rows; components beyond the type's are 0
    bool is_implemented = true;    // false if not_implemented() was called for any row
};

/// Needs a current context. @throws ShaderError
Values evaluate(const std::vector<glsl::Root>& path, const Assignment& assignment,
                const Expression& expression, const Inputs& inputs);

/// Each row's own value, of a table without groups. @throws ShaderError
std::vector<vec4> evaluate_rows(const std::vector<glsl::Root>& path, const Assignment& assignment,
                                const Expression& expression, const Inputs& inputs);

/// Whether a row's value says that not_implemented() was called.
bool is_not_implemented(vec4 value);

} // namespace sr::assignment
