#pragma once
// Laws that every BRDF obeys, as numbers.
#include "brdf/evaluator.hpp"

#include <string>

namespace sr::brdf {

/// One law: it holds while `worst` is no more than `limit`.
struct Law {
    std::string name;
    double worst = 0.0;
    double limit = 0.0;
    std::string where;      // the directions of the worst case
    bool is_waived = false; // the model violates it by its definition
    bool holds() const { return worst <= limit; }
};

/// The directions wo for which laws are checked, from grazing to normal, each at another azimuth.
std::vector<vec3> viewing_directions();

/// Checks the laws:
/// reciprocity   |f_r(wi, wo) - f_r(wo, wi)| over the larger of the two, 1e-4
/// negativity    the largest -f_r, 0; infinite where f_r is not finite
/// energy        the largest directional albedo, 1 + 1e-3
/// normalisation |∫ p dω - 1|: over the hemisphere, and what is sampled below it, 1e-2
/// sampling      Pearson's χ² of 16,384 sampled directions in 96 cells, in its standard deviations above its
///               mean, 5 (which has a probability below 1e-5)
/// The last two need sampling. @throws gl::ShaderError
std::vector<Law> check_laws(BrdfEvaluator& evaluator);

} // namespace sr::brdf
