#pragma once
// Finds the mistake that explains a difference, by trying each one that has a name.
#include "golden/differences.hpp"

#include <optional>

namespace sr::golden {

/// The mistake that explains the difference best, if one leaves at most 0.2 of it: over the whole image, or,
/// for a mistake that stays in its pixel, over the failing ones alone (then at most 0.1).
/// @param comparison its error map says which pixels fail
/// @param z the z-scores, if the noise is known: then only mistakes with nothing to fit are tried, on the
/// pixels
///          that noise does not explain
/// @param reference  the file as read: its layers are the lights that may be missing
std::optional<Diagnosis> diagnosed(const Pair& pair, const Comparison& comparison,
                                   const image::Image& reference, const CompareOptions& options,
                                   const PixelValues* z);

/// Whether the test is the reference turned on its side. Here the residual is relative to an image of one
/// colour, the reference's mean.
std::optional<Diagnosis> diagnosed_unequal_sizes(const image::Image& test, const image::Image& reference,
                                                 const CompareOptions& options);

} // namespace sr::golden
