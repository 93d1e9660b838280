#pragma once
// Errors between two pictures: ꟻLIP, and the metrics of `steradian compare`.
#include "compare/metrics.hpp"
#include "image/image.hpp"
#include "viewer/view/presenter.hpp"

namespace sr::viewer {

/// One of the two pictures.
struct ComparedPicture {
    image::Image film;         // three channels or more, radiance
    bool is_displayed = false; // or the light of a screen, 0 to 1
};

/// ꟻLIP error of each pixel, in the red channel, 0 to 1, and its mean.
struct FlipMap {
    image::Image film;
    double mean = 0.0;
};

/// An image with one or two channels as RGB.
image::Image with_colors(image::Image film);

/// HDR-ꟻLIP, or ꟻLIP of what a screen shows if one of the pictures is that.
/// @throws Error if their sizes differ
FlipMap flip_map(const ComparedPicture& test, const ComparedPicture& reference,
                 const DisplaySettings& display);

/// The metrics of `steradian compare`. If one of the pictures is what a screen shows, both are compared as
/// that. @throws Error if their sizes differ
compare::Metrics measure_errors(const ComparedPicture& test, const ComparedPicture& reference,
                                const DisplaySettings& display);

} // namespace sr::viewer
