#include "compare/rare_events.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace sr::compare {
namespace {

/// The second largest of the standard errors around a pixel that is not at the border.
float second_largest_around(const image::Image& errors, int x, int y, std::size_t channel) {
    float first = 0.0f, second = 0.0f;
    for (int v = y - 1; v <= y + 1; ++v)
        for (int u = x - 1; u <= x + 1; ++u) {
            if (u == x && v == y) continue;
            const float error = errors.at(u, v)[channel];
            second = std::max(second, std::min(error, first));
            first = std::max(first, error);
        }
    return second;
}

} // namespace

std::size_t most_events(double expected, double chance) {
    std::size_t count = 0;
    double term = std::exp(-expected), more = 1.0 - term;
    for (; more > chance && term > 0.0; more -= term) term *= expected / static_cast<double>(++count);
    return count;
}

std::size_t seen_events(const image::Image& errors, double seeds, double limit) {
    // One sample in n that is e away adds e² / n to the variance.
    const auto ratio = static_cast<float>(std::sqrt(1.0 + limit * limit / seeds));
    std::size_t count = 0;
    for (int y = 1; y + 1 < errors.height; ++y) // at the border an edge may end
        for (int x = 1; x + 1 < errors.width; ++x)
            for (std::size_t c = 0; c < static_cast<std::size_t>(errors.channels); ++c)
                if (errors.at(x, y)[c] > ratio * second_largest_around(errors, x, y, c)) {
                    ++count;
                    break;
                }
    return count;
}

} // namespace sr::compare
