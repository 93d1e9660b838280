#pragma once
// The table of inputs of a check, and how GLSL reads its rows.
#include "assignment/manifest.hpp"
#include "render/gpu/shader_evaluator.hpp"

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

} // namespace sr::assignment
