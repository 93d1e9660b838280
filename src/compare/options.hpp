#pragma once
// Options of a comparison.
#include "compare/tolerance.hpp"
#include "image/image.hpp"

#include <optional>
#include <string>
#include <vector>

namespace sr::compare {

/// A rectangle of pixels; (x, y) is its upper left one.
struct Region {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
};

/// Exposures of HDR-FLIP as powers of two: `count` of them from `start` to `stop`, evenly spaced.
struct Exposures {
    double start = 0.0;
    double stop = 0.0;
    int count = 2;
};

/// The meaning of the numbers of both images: light (.exr, .hdr), or sRGB code values in 0..1 (.png, .jpg).
enum class Encoding { scene_referred, display_referred };

struct CompareOptions {
    std::vector<Tolerance> tolerances{}; // empty: default_tolerances()
    Encoding encoding = Encoding::scene_referred;
    bool allow_nonfinite = false;         // non-finite pixels are left out instead of failing
    std::optional<Region> region{};       // only these pixels are compared
    std::optional<image::Image> mask{};   // only pixels whose first channel exceeds 0.5; of the images' size
    std::vector<image::Image> noise{};    // standard errors of each pixel of the test, the reference or both;
                                          // a 1×1 image applies to all pixels. Their squares add up.
    std::string layer{};                  // compare this layer ("key" of "key.R"); empty: the picture itself
    std::optional<Exposures> exposures{}; // of HDR-FLIP; absent: exposures_for(reference)
    float pixels_per_degree = 67.02f;     // of FLIP: a 0.7 m wide 3840-pixel screen seen from 0.7 m
};

/// The tolerances that apply if none are given; README.md gives the reasons.
/// Scene-referred: rel=0.01@99.9%, energy=0.005. Display-referred: abs=0.0079@99.9%, energy=0.01.
/// With known noise: z=auto@99.9%. density=0.25 is added wherever no density is given.
std::vector<Tolerance> default_tolerances(Encoding encoding, bool noise_is_known);

} // namespace sr::compare
