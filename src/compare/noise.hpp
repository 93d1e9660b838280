#pragma once
// Differences beside a known noise: scores of single values and sums in standard errors.
#include "compare/metrics.hpp"

namespace sr::compare {

inline constexpr int noise_block = 16;                            // [pixels] edge of a block
inline constexpr const char* seeds_attribute = "steradian:seeds"; // of a noise image: number of its pictures

/// The division of an image into blocks.
struct NoiseBlocks {
    std::size_t width = 0;
    std::size_t columns = 0;
    std::size_t count = 0;

    NoiseBlocks(int image_width, int image_height)
        : width(static_cast<std::size_t>(image_width)),
          columns((width + noise_block - 1) / noise_block),
          count(columns * ((static_cast<std::size_t>(image_height) + noise_block - 1) / noise_block)) {}
    std::size_t of(std::size_t pixel) const {
        return pixel / width / noise_block * columns + pixel % width / noise_block;
    }
    /// The upper left pixel of a block.
    std::size_t first_of(std::size_t block) const {
        return block / columns * noise_block * width + block % columns * noise_block;
    }
};

/// The largest |z| that equal images exceed once in a thousand comparisons, at each of three scales that
/// share this chance equally (Bonferroni): single values, means over blocks, means over the image.
struct NoiseLimits {
    double pixel = 0.0;
    double block = 0.0;
    double total = 0.0;
};

/// z-scores of a comparison. Those of standard errors from a few seeds are Student's t; they are given as the
/// z that is as improbable. The means over 16×16 blocks find differences below the noise of one pixel.
struct NoiseScores {
    PixelValues pixels; // largest |z| over the colours
    double max_block = 0.0;
    bool judges_blocks = false; // the errors of blocks are known
    double total = 0.0;
    NoiseLimits limits;
    std::vector<std::size_t> rare_events; // pixels that score_noise() leaves out of all scores
    std::vector<float> errors;            // standard errors of t - r, by pixel and colour
};

/// Rules for the rare events of another channel than the picture's colours.
struct RareEvents {
    bool is_coverage = false;       // of alpha: a ray through a crack between two surfaces meets none
    std::vector<std::size_t> known; // pixels that are left out already, which share the cap
};

/// The noise images that hold errors of all these channels ("key.R"); none if one of them does not, but for
/// numbers, which are the picture's.
std::vector<image::Image> noise_of(const std::vector<image::Image>& noise,
                                   const std::vector<std::string>& channels);

/// Divides differences by the standard errors in `noise`. Their squares add up, and so does the rounding of a
/// float (1e-6 of the reference). Only colours have scores, not alpha.
///
/// A pixel's variance is no less than the mean over the 3×3 pixels around it: a few seeds can agree by
/// chance. A noise image without "steradian:seeds" has as many seeds as the scatter of neighbours' variances
/// tells. One without errors of blocks has no verdict on them, and the error of the whole is the scatter of
/// the blocks' scores around their mean. A number (1×1) is noise that is independent from pixel to pixel.
///
/// A few seeds do not see rare events: one sample of a pixel meets a small lamp or its mirror image. Pixels
/// beyond the limit are such if the dimmer of the two values is no hole, darker than all around it in its own
/// image by more than the limit; the brighter one is at most four times the reference's largest; and they
/// touch at most one other. They are at most 2 and a ten-thousandth of the pixels, and no more than 48; if
/// there are more, all count. Beyond 2, they are at most as many as Poisson's law allows after those that the
/// noise's pictures had (compare/rare_events.hpp). Coverage may be lower than all around it, but changes by a
/// quarter at most.
///
/// In a sum, the few differences that lift it most count as much as the next one (Winsorised sums,
/// compare/winsorised.hpp): rare events may stay below the limit of a pixel and yet decide a sum. Their
/// number is the largest that Poisson's law allows, where 1 / (n + 2) are expected of an image whose noise is
/// that of n seeds: 3 of two images with 12 seeds, and none where the noise is known.
///
/// The sums over blocks have variances of their own, which few seeds measure. Where those of all blocks are
/// alike, they tell each other's, and a block is judged with more degrees of freedom (compare/moderated.hpp).
///
/// Where a region or a mask leaves a part of a block, the pixels left err alike as much as those of the whole
/// block do: their sum's variance is as many times that of independent pixels.
/// @param channels the names of the colours' errors; empty: the colours of the noise images
/// @throws Error if a noise image is neither of the images' size nor 1×1, or has a value that is negative or
/// not finite.
NoiseScores score_noise(const AlignedImages& images, const std::vector<image::Image>& noise,
                        const std::vector<std::string>& channels, const RareEvents& rare = {});

/// The z that a standard normal variable exceeds in absolute value with the given chance.
double two_sided_z(double chance);

/// The z that is as improbable as |t| of Student's t with that many degrees of freedom. Wallace 1959, "Bounds
/// on normal approximations to Student's and the chi-square distributions", Eq. 2.5.
double z_of_t(double t, double degrees_of_freedom);

/// The inverse of z_of_t().
double t_of_z(double z, double degrees_of_freedom);

} // namespace sr::compare
