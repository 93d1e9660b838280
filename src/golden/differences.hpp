#pragma once
// Differences pixel by pixel, and the numbers that sum them up.
#include "golden/metrics.hpp"
#include "golden/pair.hpp"

#include <vector>

namespace sr::golden {

/// One number for each compared pixel, in the order of Pair::compared: its largest over the channels.
using PixelValues = std::vector<float>;

/// What a relative error is taken to at least: 1 % of the median of the reference's colours that are not 0,
/// so that neither a dark picture nor a bright lamp moves it. 0 for an all-black reference.
double relative_floor(const Pair& pair);

PixelValues absolute_differences(const Pair& pair);

/// |t - r| / max(|r|, floor) of the colours, and |t - r| of alpha. Infinite where the divisor is 0 and t is
/// not.
PixelValues relative_differences(const Pair& pair, double floor);

/// Fills what is a sum over pixels: the abs, rel, rmse, rel_mse and energy numbers, and the counts.
void measure_differences(const Pair& pair, Metrics& metrics);

} // namespace sr::golden
