#pragma once
// Comparison of a white Lambert plane under one light, by `--estimator analytic`, with a number in doubles
// for each pixel.
#include "scene/light.hpp"

#include <functional>
#include <glm/glm.hpp>

namespace sr::testing {

/// Irradiance [W/m²] at a point of the plane y = 0, which faces +y.
using Irradiance = std::function<double(glm::dvec3 x)>;

/// Every pixel of a 9×9 picture of [-half_extent, half_extent]² is E/π within `tolerance` of the value, or of
/// a thousandth of the greatest where the light only grazes (and of 1e-3 at least, for a radiance of 1).
void expect_irradiance(const scene::Light& light, const Irradiance& E, double half_extent,
                       double tolerance = 1e-4);

} // namespace sr::testing
