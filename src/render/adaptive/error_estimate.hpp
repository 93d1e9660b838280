#pragma once
// How far a progressive picture is from what it converges to, told from two independent halves of its
// samples.
#include "image/image.hpp"

#include <vector>

namespace sr::render {

/// The error is √relMSE as `steradian compare` defines relMSE (RGB relative to value and floor, alpha
/// absolute), against the picture of endlessly many samples: noise and aliasing. What an estimator's bias
/// adds, no half sees.
struct ErrorEstimate {
    double error = 0.0;    // √relMSE that the picture keeps under in most cases: see estimated_error()
    double expected = 0.0; // √relMSE without that allowance
    double floor = 0.0;    // [the film's unit]
    int width = 0;
    int height = 0;
    /// Of each pixel, rows from top to bottom: its expected share of relMSE, the mean over its four channels.
    std::vector<float> squares;
};

/// Sets `error` and `expected` from the squares.
void sum_up(ErrorEstimate& estimate);

/// `mean` of all samples, RGBA, and of the `first` half's, of which a pixel has one more than of the second
/// if their number, `samples`, is odd. Each pixel has two at least.
///
/// If both halves were the same size, a and b, half their difference would have the variance of their mean,
/// for they are independent: E((a - b)²/4) = Var((a + b)/2). It is taken relative to the lesser of a and b,
/// lest a firefly in one of them excuse itself. The mean over the picture is itself uncertain, most where few
/// pixels make up most of it, so `error` adds its standard error over blocks of 8×8 pixels.
ErrorEstimate estimated_error(const image::Image& mean, const image::Image& first,
                              const std::vector<int>& samples);

} // namespace sr::render
