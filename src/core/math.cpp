#include "core/math.hpp"

#include <algorithm>
#include <cmath>

namespace sr {

std::optional<double> chi_squared_excess(const std::vector<double>& expected,
                                         const std::vector<double>& counts) {
    double statistic = 0.0, few = 0.0, few_counted = 0.0;
    int freedom = -1;
    const auto add = [&](double e, double n) {
        statistic += (n - e) * (n - e) / e;
        ++freedom;
    };
    for (std::size_t i = 0; i < expected.size(); ++i) {
        if (expected[i] >= 10.0) {
            add(expected[i], counts[i]);
        } else {
            few += expected[i];
            few_counted += counts[i];
        }
    }
    if (few >= 10.0 || few_counted > 40.0) add(std::max(few, 1.0), few_counted);
    if (freedom < 1) return std::nullopt;
    return (statistic - freedom) / std::sqrt(2.0 * freedom);
}

} // namespace sr
