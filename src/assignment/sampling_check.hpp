#pragma once
// Samples: whether directions are as dense as their density says (χ²), and whether an estimator's error falls
// as it should.
#include "assignment/evaluation.hpp"
#include "assignment/finding.hpp"

namespace sr::assignment {

/// Directions that `check.value` draws from its input `u`, against the density `check.other` of the direction
/// `w` [1/sr]. Needs a current context. @throws ShaderError
Finding check_samples(const Assignment& assignment, const Parameters& parameters, const Check& check,
                      const Codes& codes);

/// How the root mean square of `check.value` - `check.other` over the inputs and 256 values of `seed` falls
/// with `count`: the slope of its logarithm. Needs a current context. @throws ShaderError
Finding check_slope(const Assignment& assignment, const Parameters& parameters, const Check& check,
                    const Codes& codes);

} // namespace sr::assignment
