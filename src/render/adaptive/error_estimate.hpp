#pragma once
// Error of a progressive picture against its limit, estimated from two independent halves of its samples.
#include "image/image.hpp"

#include <vector>

namespace sr::render {

/// The error is √relMSE as `steradian compare` defines relMSE (RGB relative to value and floor, alpha
/// absolute), against the limit of the picture: noise and aliasing. It does not contain the bias of an
/// estimator, which both halves share.
struct ErrorEstimate {
    double error = 0.0;    // bound on √relMSE that most pictures keep: see estimate_error()
    double expected = 0.0; // √relMSE without that allowance
    double floor = 0.0;    // [the film's unit]
    int width = 0;
    int height = 0;
    /// Of each pixel, rows from top to bottom: its expected share of relMSE, the mean over its four channels.
    std::vector<float> squares;
};

/// Sets `error` and `expected` from the squares.
void sum_up(ErrorEstimate& estimate);

/// Estimates the error of `mean`, the mean of all samples in RGBA. `first` is the mean of the first half's
/// samples. If a pixel's number of samples is odd, the first half has one more than the second. Each pixel
/// has two samples at least.
///
/// Let a and b be the means of two independent halves of the same size. Half their difference has the
/// variance of their mean: E((a - b)²/4) = Var((a + b)/2). It is relative to a·b, which estimates the value's
/// square without the squares of the errors, so that a firefly in one half does not hide itself. The mean
/// over the picture is itself uncertain, most where few pixels make up most of it, so `error` adds its
/// standard error over blocks of 8×8 pixels.
ErrorEstimate estimate_error(const image::Image& mean, const image::Image& first,
                             const std::vector<int>& samples);

} // namespace sr::render
