#pragma once
// Options of a comparison.
#include "compare/tolerance.hpp"
#include "image/image.hpp"

#include <optional>
#include <string>
#include <vector>

namespace sr::compare {

/// A rectangle of pixels; (x, y) is its upper left one.
struct PixelRegion {
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
    int bits = 8;                        // of a code value of a display-referred image
    bool allow_nonfinite = false;        // non-finite pixels are left out instead of failing
    std::optional<PixelRegion> region{}; // only these pixels are compared
    std::optional<image::Image> mask{};  // only pixels whose first channel exceeds 0.5; of the images' size
    std::vector<image::Image> noise{};   // standard errors of each pixel of the test, the reference or both;
                                         // a 1×1 image applies to all pixels. Their squares add up.
    std::string layer{};                 // compare this layer ("key" of "key.R"); empty: the picture itself
    /// Layers that are compared beside the picture; absent: all of the reference, and channels that are no
    /// colour.
    std::optional<std::vector<std::string>> other_layers{};
    std::optional<Exposures> exposures{}; // of HDR-FLIP; absent: exposures_for(reference)
    float pixels_per_degree = 67.02f;     // of FLIP: a 0.7 m wide 3840-pixel screen seen from 0.7 m
    bool measures_appearance = true;      // FLIP and SSIM too, where no tolerance limits them
    bool diagnoses = true;
};

/// The bits of the integers, 8 or 16, that the file of an image held; 0 if it held floats.
int integer_bits(const image::Image& image);

/// Takes the encoding and the bits from what the files held: two files of integers hold codes for a screen.
void set_encoding(CompareOptions& options, const image::Image& test, const image::Image& reference);

/// The tolerances that apply if none are given; README.md gives the reasons.
/// Scene-referred: rel=0.01@edges, energy=0.005. Display-referred: abs=0.0079@edges, energy=0.01; of 16 bits
/// abs=0.001@edges. With known noise: z=auto@edges. density=0.25 is added wherever a share of the pixels may
/// fail and no density is given.
/// @param bits of a code value
std::vector<Tolerance> default_tolerances(Encoding encoding, bool noise_is_known, int bits = 8);

} // namespace sr::compare
