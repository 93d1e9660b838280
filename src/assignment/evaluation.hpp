#pragma once
// Evaluation of a GLSL expression over a table of inputs, with some regions of the reference replaced.
#include "assignment/manifest.hpp"
#include "assignment/parameters.hpp"
#include "assignment/reference_values.hpp"
#include "render/gpu/shader_evaluator.hpp"

#include <map>
#include <span>
#include <string>
#include <vector>

namespace sr::assignment {

/// A table of inputs. Its rows form groups of equal size, over which values are averaged.
struct Inputs {
    std::vector<Input> columns;
    std::vector<render::Row> rows;
    std::size_t group = 1;
    std::string identity; // equal tables have equal texts
};

/// Makes `rows` groups, each with `mean_count` values of the column `mean_over` (one if that is empty).
/// Columns are stratified; the first rows hold the ends of each range. A seed gives the same table each time.
Inputs inputs_of(std::vector<Input> columns, int rows, const std::string& mean_over = "", int mean_count = 1,
                 unsigned int seed = 1);

/// The same rows with each number moved by one or two units in its last place, up or down.
Inputs nudged(const Inputs& inputs);

/// The GLSL that declares the columns as variables of their names.
std::string declarations(std::span<const Input> columns);

/// Formats a row for people, without the column `without`: "cos_h 0.3, alpha 0.5".
std::string describe(const Inputs& inputs, std::size_t row, const std::string& without);

/// The code of a region, and its place for error messages.
struct Code {
    std::string place;
    int line = 1; // of the text's first line, counted from 1
    std::string text;
};

/// Code that replaces the reference's, by the region's name.
using Codes = std::map<std::string, Code>;

/// The roots of the shaders: the codes, which are untrusted, the reference around them, the assignment's
/// overlay/, the program's shaders.
std::vector<glsl::Root> shader_path(const Assignment& assignment, const Parameters& parameters,
                                    const Codes& codes);

/// An expression and its GLSL type, float to vec4, bool or int.
struct Expression {
    std::string text;
    std::string type;
};

/// The number of components of a type.
int components_of(const std::string& type);

struct Values {
    std::vector<glm::dvec4> means; // of each group of rows; components beyond the type's are 0
    bool is_implemented = true;    // false if not_implemented() was called for any row
};

/// Evaluates an expression for each group. Needs a current context. @throws ShaderError
Values evaluate(const std::vector<glsl::Root>& path, const Assignment& assignment,
                const Expression& expression, const Inputs& inputs);

/// Evaluates an expression of the reference, or with `codes` of one of its variants, for each table. All
/// tables have the same columns. What `known` has is not computed again; what is computed is added there.
/// @throws ShaderError; LoopError if a loop was stopped
std::vector<Values> evaluate_reference(ReferenceValues& known, const Assignment& assignment,
                                       const Parameters& parameters, const Codes& codes,
                                       const Expression& expression, const std::vector<Inputs>& tables);

/// The parts of a key (reference_values.hpp) that name such a program.
std::vector<std::string> identity_of(const Assignment& assignment, const Parameters& parameters,
                                     const Codes& codes);

/// Evaluates an expression for each row. @throws ShaderError
std::vector<vec4> evaluate_rows(const std::vector<glsl::Root>& path, const Assignment& assignment,
                                const Expression& expression, const Inputs& inputs);

/// True if a row's value says that not_implemented() was called.
bool is_not_implemented(vec4 value);

} // namespace sr::assignment
