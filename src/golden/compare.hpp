#pragma once
// Whether a test image agrees with a reference image, by how much not, and why not.
#include "golden/diagnosis.hpp"
#include "golden/metrics.hpp"
#include "golden/tolerance.hpp"
#include "image/image.hpp"

#include <optional>
#include <string>
#include <vector>

namespace sr::golden {

/// A rectangle of pixels; (x, y) is its upper left one.
struct Region {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
};

/// Exposures of HDR-FLIP, as powers of two: `count` of them from `start` to `stop`, at equal distances.
struct Exposures {
    double start = 0.0;
    double stop = 0.0;
    int count = 2;
};

/// What the numbers of both images are: light (.exr, .hdr), or codes for a screen (.png, .jpg; sRGB, 0..1).
enum class Encoding { scene_referred, display_referred };

struct CompareOptions {
    std::vector<Tolerance> tolerances{}; // empty: default_tolerances()
    Encoding encoding = Encoding::scene_referred;
    bool allow_nonfinite = false;       // pixels that are not finite are left out instead of failing
    std::optional<Region> region{};     // only these pixels are compared
    std::optional<image::Image> mask{}; // only pixels whose first channel exceeds 0.5; of the images' size
    std::vector<image::Image> noise{};  // standard errors, pixel by pixel, of the test or of the reference or
                                        // of both; a 1×1 image holds for all pixels. Their squares add up.
    std::string layer{};                // compare this layer ("key" of "key.R"); empty: the picture itself
    std::optional<Exposures> exposures{}; // of HDR-FLIP; absent: from the reference, see README.md
    float pixels_per_degree = 67.02f;     // of FLIP: a 0.7 m wide 3840-pixel screen seen from 0.7 m
};

/// One line of the verdict.
struct Verdict {
    bool passed = true;
    std::string line; // "rel ≤ 0.01 in 99.9 % of the pixels: 97.8 % are (max 2.14)"
};

struct Comparison {
    bool passed = false;
    std::vector<Verdict> verdicts; // non-finite pixels, size and channels first; then one for each tolerance
    Metrics metrics;
    std::optional<Diagnosis> diagnosis; // only of images that fail
    /// One channel, of the reference's size: each pixel's error over its limit (1 just passes), NaN where a
    /// pixel is not finite, -1 where it is not compared. Empty (0 × 0) if the images cannot be compared.
    image::Image error;
};

/// The limits in use where none are given. README.md says why.
/// Scene-referred: rel=0.01@99.9%, energy=0.005. Display-referred: abs=0.0079@99.9%, energy=0.01.
/// With a noise floor: z=auto@99.9%. A limit on density (0.25) is added wherever none is written.
std::vector<Tolerance> default_tolerances(Encoding encoding, bool noise_is_known);

/// Compares, and never throws for what is wrong with the images: a difference in size or channels is a
/// failure.
/// @throws Error for options that do not fit: a region outside the reference, a mask or noise of another
/// size, a layer that the reference does not have, nothing left to compare.
Comparison compare(const image::Image& test, const image::Image& reference,
                   const CompareOptions& options = {});

} // namespace sr::golden
