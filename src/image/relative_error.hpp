#pragma once
// The denominator of relative errors: one definition for comparing pictures and for pictures that know their
// own error.
#include <vector>

namespace sr::image {

/// Returns the smallest denominator of a relative error: 1 % of the median magnitude of those colours that
/// are not 0, so that neither a dark picture nor a bright lamp moves it. 0 if all are 0.
double relative_floor(std::vector<float> colors);

/// (difference / reference)², with the floor added in squares: what relMSE is the mean of. 0 for no
/// difference.
double relative_square(double difference, double reference, double floor);

} // namespace sr::image
