#pragma once
// Diagnosis of a difference: the mistake that would turn the reference into the test image.
#include "compare/metrics.hpp"

#include <optional>
#include <string>

namespace sr::compare {

/// A mistake that explains the difference.
struct Diagnosis {
    std::string name;      // "pi_missing", "flipped_y", "light_missing", …: README.md lists them
    std::string statement; // one sentence for people: "test = 3.1416 × reference everywhere: …"
    double residual = 1.0; // share of the difference that is left after applying the mistake to the
                           // reference: 0 all is explained, 1 nothing; at most 0.2, for fits 0.1
    std::string layer;     // the light, where the mistake is one light's ("key"); else empty
};

/// A comparison that failed.
struct Failure {
    const AlignedImages& images;
    const image::Image& error;     // Comparison::error of the picture alone, which tells the failing pixels
    const image::Image& test;      // the files as read: the reference's layers are lights that may be missing
    const image::Image& reference; // the same
    bool is_wrong_as_a_whole;      // a limit on a mean or a sum is exceeded
    const CompareOptions& options;
    const PixelValues* z; // z-scores, if the noise is known: then the pixels are looked at that noise does
                          // not explain, and only hypotheses are tried that fit nothing, or fit to all pixels
};

/// Finds the mistake that explains the difference best, if it leaves at most 0.2 of it: over the whole image,
/// or, for a mistake that acts within a pixel, over the failing pixels alone (then at most 0.1).
/// A difference that does not fail the picture is no cause: where only pixels fail, and most of the
/// difference lies in others, the failing pixels alone are looked at.
std::optional<Diagnosis> diagnose(const Failure& failure);

/// Finds whether the test is the reference turned on its side, or at another size. Here the residual is
/// relative to an image of one colour, the reference's mean.
std::optional<Diagnosis> diagnose_unequal_sizes(const image::Image& test, const image::Image& reference,
                                                const CompareOptions& options);

} // namespace sr::compare
