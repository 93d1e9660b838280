#include "compare/moderated.hpp"

#include <cmath>
#include <numeric>

namespace sr::compare {
namespace {

constexpr std::size_t fewest_variances = 10;
constexpr double largest_half_degrees = 5e5; // as good as a common variance

/// The derivative of ln Γ, for x > 0. Abramowitz and Stegun 1964, Eq. 6.3.5 and 6.3.18.
double digamma(double x) {
    double sum = 0.0;
    for (; x < 8.0; x += 1.0) sum -= 1.0 / x;
    const double y = 1.0 / (x * x);
    return sum + std::log(x) - 0.5 / x - y * (1.0 / 12.0 - y * (1.0 / 120.0 - y / 252.0));
}

/// Its derivative. Abramowitz and Stegun 1964, Eq. 6.4.6 and 6.4.12.
double trigamma(double x) {
    double sum = 0.0;
    for (; x < 8.0; x += 1.0) sum += 1.0 / (x * x);
    const double y = 1.0 / (x * x);
    return sum + 1.0 / x + 0.5 * y + y / x * (1.0 / 6.0 - y * (1.0 / 30.0 - y / 42.0));
}

/// The x with that trigamma, which falls from infinity at 0; at most largest_half_degrees.
double inverse_trigamma(double value) {
    double low = 1e-6, high = largest_half_degrees;
    for (int i = 0; i < 100; ++i) {
        const double middle = std::sqrt(low * high);
        (trigamma(middle) > value ? low : high) = middle;
    }
    return high;
}

} // namespace

VariancePrior prior_of(const std::vector<double>& variances, double degrees_of_freedom) {
    std::vector<double> logarithms;
    const double half = 0.5 * degrees_of_freedom;
    for (const double variance : variances)
        if (variance > 0.0) logarithms.push_back(std::log(variance) - digamma(half) + std::log(half));
    if (logarithms.size() < fewest_variances) return {};
    const auto count = static_cast<double>(logarithms.size());
    const double mean = std::accumulate(logarithms.begin(), logarithms.end(), 0.0) / count;
    double scatter = 0.0;
    for (const double value : logarithms) scatter += (value - mean) * (value - mean) / (count - 1.0);
    const double more = scatter * (1.0 + std::sqrt(2.0 / (count - 1.0))) - trigamma(half);
    const double prior_half = more > 0.0 ? inverse_trigamma(more) : largest_half_degrees;
    return {std::exp(mean + digamma(prior_half) - std::log(prior_half)), 2.0 * prior_half};
}

} // namespace sr::compare
