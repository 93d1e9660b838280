#pragma once
// A picture as two noisy programs measured it.
#include "image/image.hpp"

#include <string>
#include <vector>

namespace sr::truth {

/// Mean of independent renderings, and the standard error of that mean; RGB, cell_size² pixels.
struct Measured {
    image::Image mean;
    image::Image noise;
};

/// From the means of equally large, independent sets of samples, `enlargement` times as wide and high as the
/// result. The variance is taken over the sets, pixel by pixel of theirs, so that few sets tell much.
Measured measured(const std::vector<image::Image>& sets, int enlargement);

/// The means of the film's squares of `enlargement`² pixels; RGB.
image::Image reduced(const image::Image& film, int enlargement);

/// The same with the root mean square of the noise of the 3×3 pixels around: of few sets, so that a pixel
/// that chance left dark has its neighbours' noise.
Measured with_shared_noise(Measured picture);

/// Difference between `ours` and `reference`.
struct Distance {
    double energy = 0.0;       // |Σ ours / Σ reference - 1|, the worst channel
    double energy_noise = 0.0; // what noise alone is expected to make of it, one standard deviation
    double largest = 0.0;      // |ours - reference| in units of both noises together, the worst pixel
    double beyond_three = 0.0; // share of pixels that are more than three of these units away
    double rms = 0.0;          // root mean square of these units, 1 if there is nothing but noise
    double median = 0.0;       // of |ours / reference - 1| over pixels and channels
    double p95 = 0.0;
    double noise = 0.0; // median of the noise of both relative to the reference
};

Distance distance(const Measured& ours, const Measured& reference);

} // namespace sr::truth
