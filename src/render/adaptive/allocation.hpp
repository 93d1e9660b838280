#pragma once
// Allocation of samples: which pixels go on, so that the fewest samples lead to an error.
#include "render/adaptive/converged_pixels.hpp"
#include "render/adaptive/error_estimate.hpp"

#include <vector>

namespace sr::render {

/// Returns the pixels that have enough of `samples` for √relMSE to end at `target`, those that have stopped
/// before included. The others have `count` samples each.
///
/// A pixel's square is v/n with its n samples. The fewest samples for a given sum of squares leave all that
/// work the same v/n², so that n goes with √v (Neyman 1934, the optimum allocation to strata; here by
/// Lagrange's method). So a pixel has enough as soon as its square is under a level, which rises with n. The
/// level is the highest that leads to the target, squares of other pixels and the error's allowance included
/// (sum_up()). A pixel stands for its surroundings here: the largest mean square of its block of 4×4 pixels
/// and the eight blocks around it, since single pixels tell little, and an edge that has just entered one
/// block is in the next.
PixelMask with_enough_samples(const ErrorEstimate& estimate, const std::vector<int>& samples, int count,
                              double target);

} // namespace sr::render
