#pragma once
// What every BRDF must obey, in numbers.
#include "brdf/trial.hpp"

#include <string>

namespace sr::brdf {

/// One law: it holds while `worst` is no more than `limit`.
struct Law {
    std::string name;
    double worst = 0.0;
    double limit = 0.0;
    std::string where;      // the directions of the worst case
    bool is_waived = false; // the model breaks it by its definition
    bool holds() const { return worst <= limit; }
};

/// Directions that the laws are looked at for: cosines of wo with the normal, in three azimuths by turns.
std::vector<vec3> viewing_directions();

/// reciprocity   |f_r(wi, wo) - f_r(wo, wi)| over the larger of the two, 1e-4
/// negativity    how far below zero f_r goes, 0; infinite where it is not finite
/// energy        the largest directional albedo, 1 + 1e-3
/// normalisation |∫ p dω - 1|: over the hemisphere, and what is sampled below it, 1e-2
/// sampling      Pearson's χ² of 16,384 sampled directions in 96 cells, in its standard deviations above its
///               mean, 5 (which has a probability below 1e-5)
/// The last two are left out where there is no sampling. @throws gl::ShaderError
std::vector<Law> laws_of(Trial& trial);

} // namespace sr::brdf
