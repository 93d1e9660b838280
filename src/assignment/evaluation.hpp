#pragma once
// Evaluation of a GLSL expression over a table of inputs, with some regions of the reference replaced.
#include "assignment/manifest.hpp"
#include "assignment/parameters.hpp"
#include "render/glsl_table.hpp"

#include <map>
#include <span>
#include <string>
#include <vector>

namespace sr::assignment {

/// Rows in groups of equal size; the values of a group are averaged.
struct Inputs {
    std::vector<Input> columns;
    std::vector<render::Row> rows;
    std::size_t group = 1;
};

/// `rows` groups, each with `mean_count` values of the column `mean_over` (one if that is empty). Columns are
/// stratified, and the first rows have a column's ends. The same at every call.
Inputs inputs_of(std::vector<Input> columns, int rows, const std::string& mean_over = "", int mean_count = 1);

/// The same rows, each number moved by one or two units in its last place, to and fro.
Inputs nudged(const Inputs& inputs);

/// The GLSL that declares the columns as variables of their names.
std::string declarations(std::span<const Input> columns);

/// "cos_h 0.3, alpha 0.5": a row as people read it, less the column `without`.
std::string described(const Inputs& inputs, std::size_t row, const std::string& without);

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
