#include "scene/profile.hpp"

#include <cmath>

namespace sr::scene {
namespace {

/// ∫ (a + b γ) sinγ dγ from g0 to g1 for the line through (g0, I0) and (g1, I1).
double over_gamma(double g0, double I0, double g1, double I1) {
    const double b = g1 > g0 ? (I1 - I0) / (g1 - g0) : 0.0;
    const auto antiderivative = [&](double g) { // of (I0 + b (γ - g0)) sinγ
        return -(I0 + b * (g - g0)) * std::cos(g) + b * std::sin(g);
    };
    return antiderivative(g1) - antiderivative(g0);
}

} // namespace

double flux_of(const LightProfile& profile) {
    const std::size_t rows = profile.gamma.size();
    std::vector<double> columns; // ∫ I sinγ dγ at each φ
    for (std::size_t c = 0; c < profile.phi.size(); ++c) {
        double sum = 0.0;
        for (std::size_t r = 1; r < rows; ++r)
            sum += over_gamma(profile.gamma[r - 1], profile.I[c * rows + r - 1], profile.gamma[r],
                              profile.I[c * rows + r]);
        columns.push_back(sum);
    }
    double flux = 0.0;
    for (std::size_t c = 1; c < columns.size(); ++c)
        flux += 0.5 * (columns[c] + columns[c - 1])
                * (static_cast<double>(profile.phi[c]) - static_cast<double>(profile.phi[c - 1]));
    return flux;
}

} // namespace sr::scene
