#pragma once
// Variances from few seeds, of many blocks: each tells something of the others.
#include <vector>

namespace sr::compare {

/// The distribution of the true values of many variances, as if `degrees_of_freedom` more observations of
/// each had the variance `value`. Smyth 2004, "Linear models and empirical Bayes methods for assessing
/// differential expression in microarray experiments", Sec. 3 and 6.2.
struct VariancePrior {
    double value = 1.0;
    double degrees_of_freedom = 0.0; // 0: the variances tell nothing of each other

    /// The posterior mean of a variance that was measured with so many degrees of freedom.
    double moderated(double measured, double measured_degrees) const {
        return (degrees_of_freedom * value + measured_degrees * measured)
               / (degrees_of_freedom + measured_degrees);
    }
};

/// Fits the prior to variances that were measured with the same degrees of freedom, by the moments of their
/// logarithms. The scatter of these is taken one standard error larger than it is: so few variances promise
/// no more than they hold. Fewer than ten tell nothing; values of 0 are left out.
VariancePrior prior_of(const std::vector<double>& variances, double degrees_of_freedom);

} // namespace sr::compare
