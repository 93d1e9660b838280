#pragma once
// What a comparison of two images measures.
#include <array>
#include <cstddef>
#include <limits>

namespace sr::golden {

/// What a metric is that cannot be computed.
inline constexpr double not_measured = std::numeric_limits<double>::quiet_NaN();

/// Every number of a comparison. Colours are R, G and B (or grey), with alpha as one more channel where both
/// images have it. All but the non-finite counts are taken over the pixels that are inside the region and the
/// mask and finite in both images. What cannot be computed is NaN.
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
    double failing_fraction = not_measured; // of the compared pixels, over a limit that is set pixel by pixel
    double density = not_measured;          // largest share of failing pixels in any 16×16 window
    double max_z = not_measured;            // with a noise floor: max |t - r| / σ over pixels and channels,
    double max_block_z = not_measured;      // of the sums over 16×16 blocks,
    double total_z = not_measured;          // and of the sums over the image
};

} // namespace sr::golden
