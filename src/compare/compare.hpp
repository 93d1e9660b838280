#pragma once
// Comparison of a test image with a reference image: whether they agree, by how much not, and why not.
#include "compare/diagnose.hpp"
#include "compare/verdict.hpp"

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <vector>

namespace sr::compare {

struct Comparison {
    bool passed = false;
    std::vector<Verdict> verdicts; // non-finite pixels, size and channels first; then one for each tolerance,
                                   // then those of other channels
    Metrics metrics;
    std::optional<Diagnosis> diagnosis; // only of images that fail
    /// One channel, of the reference's size: each pixel's error over its limit (1 just passes), NaN where a
    /// pixel is not finite, -1 where it is not compared. Empty (0 × 0) if the images cannot be compared.
    image::Image error;
};

/// Compares two images. A difference in size or channels is a failure, not an exception.
/// @throws Error for options that do not fit: a region outside the reference, a mask or noise of another
/// size, a layer that the reference does not have, nothing left to compare.
Comparison compare(const image::Image& test, const image::Image& reference,
                   const CompareOptions& options = {});

/// {"passed", "verdicts": [{"passed", "line"}], "metrics": {…}, "diagnosis": null | {…}}. A number that is
/// not finite is the string "nan", "inf" or "-inf", since JSON has none. A metric that is not measured is
/// absent.
nlohmann::ordered_json json_of(const Comparison& comparison);

} // namespace sr::compare
