#pragma once
// Metrics of a comparison: errors by pixel and in sum, the clustering of failures, SSIM.
#include "compare/align.hpp"
#include "compare/planes.hpp"

#include <array>
#include <cstddef>
#include <limits>
#include <string_view>
#include <variant>
#include <vector>

namespace sr::compare {

/// The value of a metric that cannot be computed.
inline constexpr double not_measured = std::numeric_limits<double>::quiet_NaN();

/// Every number of a comparison. Colours are R, G and B (or grey); alpha is one more channel where both
/// images have it. All but the non-finite counts cover the compared pixels: inside the region and the mask,
/// and finite in both images.
struct Metrics {
    std::size_t pixels = 0;         // compared
    std::size_t nonfinite_test = 0; // pixels with a NaN or an infinity, inside the region and mask
    std::size_t nonfinite_reference = 0;
    double floor = not_measured; // values below it count as this large in relative errors: 1 % of the median
                                 // of the reference's values that are not 0
    double max_abs = not_measured;  // max |t - r| over pixels and channels
    double mean_abs = not_measured; // mean |t - r|
    double max_rel = not_measured;  // max |t - r| / max(|r|, floor)
    double mean_rel = not_measured;
    double rmse = not_measured;    // sqrt(mean (t - r)²)
    double rel_mse = not_measured; // mean (t - r)² / (r² + floor²)
    std::array<double, 3> energy_ratio{not_measured, not_measured,
                                       not_measured}; // Σ t / Σ r; 1 if both are 0
    double flip = not_measured;             // mean LDR-FLIP (Andersson 2020) of the displayed images, 0..1
    double hdr_flip = not_measured;         // mean HDR-FLIP (Andersson 2021); scene-referred images only
    double ssim = not_measured;             // mean SSIM (Wang 2004) of the displayed images' luma; 1 is equal
    double failing_fraction = not_measured; // of the compared pixels: over a limit on pixels
    double density = not_measured;          // largest share of failing pixels in any 16×16 window
    double max_z = not_measured;            // with known noise: max |t - r| / σ over pixels and channels,
    double max_block_z = not_measured;      // of the sums over 16×16 blocks,
    double total_z = not_measured;          // and of the sums over the image
};

/// A metric with its name in JSON and in texts.
struct NamedMetric {
    std::string_view name;
    std::variant<double Metrics::*, std::array<double, 3> Metrics::*> member;
    bool is_share = false; // texts give it in percent
};

/// All metrics but the counts, in the order of JSON and of texts.
inline constexpr std::array named_metrics{NamedMetric{"floor", &Metrics::floor},
                                          NamedMetric{"max_abs", &Metrics::max_abs},
                                          NamedMetric{"mean_abs", &Metrics::mean_abs},
                                          NamedMetric{"max_rel", &Metrics::max_rel},
                                          NamedMetric{"mean_rel", &Metrics::mean_rel},
                                          NamedMetric{"rmse", &Metrics::rmse},
                                          NamedMetric{"rel_mse", &Metrics::rel_mse},
                                          NamedMetric{"energy_ratio", &Metrics::energy_ratio},
                                          NamedMetric{"flip", &Metrics::flip},
                                          NamedMetric{"hdr_flip", &Metrics::hdr_flip},
                                          NamedMetric{"ssim", &Metrics::ssim},
                                          NamedMetric{"failing_fraction", &Metrics::failing_fraction, true},
                                          NamedMetric{"density", &Metrics::density, true},
                                          NamedMetric{"max_z", &Metrics::max_z},
                                          NamedMetric{"max_block_z", &Metrics::max_block_z},
                                          NamedMetric{"total_z", &Metrics::total_z}};
static_assert(sizeof(Metrics) == 3 * sizeof(std::size_t) + (named_metrics.size() + 2) * sizeof(double),
              "every metric has a row; the energy ratio has three values");

/// One number for each compared pixel, in the order of AlignedImages::compared: the largest of its channels.
using PixelValues = std::vector<float>;

/// The smallest divisor of a relative error: 1 % of the median of the reference's colours that are not 0, so
/// that neither a dark picture nor a bright lamp moves it. 0 for an all-black reference.
double relative_floor(const AlignedImages& images);

/// |t - r|.
PixelValues absolute_differences(const AlignedImages& images);

/// The same of each channel of a layer by itself: depth may stand beside unit vectors. A channel that is 0
/// everywhere takes that of the layer.
std::vector<double> channel_floors(const AlignedImages& images);

/// |t - r| / max(|r|, floor) of the colours, and |t - r| of alpha. Infinite where the divisor is 0 and t is
/// not.
/// @param floors one for each colour
PixelValues relative_differences(const AlignedImages& images, std::span<const double> floors);

/// 1 + Σ (t - r) / Σ |r| of each colour over the compared pixels but those left out.
std::vector<double> energy_ratios(const AlignedImages& images, const std::vector<bool>& left_out);

/// Fills the abs, rel, rmse, rel_mse and energy numbers, and the counts.
void measure_differences(const AlignedImages& images, Metrics& metrics);

inline constexpr int density_window = 16; // [pixels] edge

/// The failing pixels of the window that has most of them.
struct Density {
    int most = 0;
    double share = 0.0; // of the window's pixels
};

/// Finds the densest square window (along an edge of the image that is shorter, it ends there). `fails` has
/// one entry for each compared pixel; all other pixels pass.
Density densest_window(const AlignedImages& images, const std::vector<bool>& fails, int edge);

/// The mean structural similarity of two planes in 0..1; 1 if they are equal. The mean covers the windows
/// inside the image (11×11, Gaussian of σ = 1.5), or all windows of a smaller image.
/// Wang, Bovik, Sheikh, Simoncelli 2004, "Image quality assessment: from error visibility to structural
/// similarity".
double ssim(const Plane& test, const Plane& reference);

} // namespace sr::compare
