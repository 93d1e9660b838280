#pragma once
// True if samples fall where their density says.
#include <optional>
#include <vector>

namespace sr {

/// Pearson's statistic of counted against expected samples, in its standard deviations above its mean. Cells
/// that expect fewer than 10 samples are one cell together. Absent where fewer than two cells are left.
std::optional<double> chi_squared_excess(const std::vector<double>& expected,
                                         const std::vector<double>& counts);

} // namespace sr
