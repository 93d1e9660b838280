#pragma once
// Minimises a function of three numbers without its derivatives. Nelder & Mead 1965, with their coefficients.
#include <algorithm>
#include <array>

namespace sr::ltc {

using Place = std::array<double, 3>;

/// The best place after `steps` steps from a simplex of edge `size` at `start`.
template<class Function>
Place minimum(const Function& f, Place start, double size, int steps) {
    struct Corner {
        Place at;
        double value;
    };
    std::array<Corner, 4> corners;
    for (std::size_t i = 0; i < 4; ++i) {
        Place at = start;
        if (i > 0) at[i - 1] += size;
        corners[i] = {at, f(at)};
    }
    const auto by_value = [](const Corner& a, const Corner& b) { return a.value < b.value; };
    for (int step = 0; step < steps; ++step) {
        std::sort(corners.begin(), corners.end(), by_value);
        Corner& worst = corners[3];
        const auto along = [&](double t) { // from the mean of the others through (t < 0) or towards the worst
            Place at{};
            for (std::size_t k = 0; k < 3; ++k) {
                const double mean = (corners[0].at[k] + corners[1].at[k] + corners[2].at[k]) / 3.0;
                at[k] = mean + t * (worst.at[k] - mean);
            }
            return Corner{at, f(at)};
        };
        const Corner reflected = along(-1.0);
        if (reflected.value < corners[0].value) {
            const Corner expanded = along(-2.0);
            worst = expanded.value < reflected.value ? expanded : reflected;
        } else if (reflected.value < corners[2].value) {
            worst = reflected;
        } else {
            const Corner contracted = along(reflected.value < worst.value ? -0.5 : 0.5);
            if (contracted.value < std::min(reflected.value, worst.value)) {
                worst = contracted;
                continue;
            }
            for (std::size_t i = 1; i < 4; ++i) {
                for (std::size_t k = 0; k < 3; ++k)
                    corners[i].at[k] = 0.5 * (corners[i].at[k] + corners[0].at[k]);
                corners[i].value = f(corners[i].at);
            }
        }
    }
    return std::min_element(corners.begin(), corners.end(), by_value)->at;
}

} // namespace sr::ltc
