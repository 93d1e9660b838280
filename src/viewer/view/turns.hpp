#pragma once
// Turns of a render beside the window's other work: rows of a sample at a time.
#include <algorithm>

namespace sr::viewer {

inline constexpr double turn_budget = 0.040; // [s] of sampling between two looks at keys and pointer

/// Rows of a sample of `height` rows that fit into `budget` seconds, or a part of it that costs no more
/// vertices than needed. `expected`: time of the sample [s].
inline int rows_of_turn(int height, double expected, double budget) {
    constexpr int max_parts =
        10; // of a sample: each part reads all vertices of the scene again, several times
    constexpr double max_part = 0.4; // [s] of a sample that takes so long that its vertices do not matter
    const int parts = std::max(max_parts, static_cast<int>(std::min(expected / max_part, 1.0 * height)));
    const double fitting = expected > 0.0 ? height * budget / expected : 1.0 * height;
    return std::clamp(static_cast<int>(std::min(fitting, 1.0 * height)), (height + parts - 1) / parts,
                      height);
}

} // namespace sr::viewer
