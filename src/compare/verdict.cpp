#include "compare/verdict.hpp"

#include "core/error.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace sr::compare {
namespace {

double limit_of(const Tolerance& tolerance, const Measurements& measurements) {
    const bool is_automatic = tolerance.measure == Measure::z && tolerance.limit == 0.0;
    return is_automatic && measurements.noise ? measurements.noise->limits.pixel : tolerance.limit;
}

PixelValues at_compared(const Plane& plane, const AlignedImages& images) {
    PixelValues values;
    for (const std::size_t i : images.compared) values.push_back(plane.values[i]);
    return values;
}

/// The limited quantity at each compared pixel.
PixelValues pixel_values(Measure measure, const AlignedImages& images, const Measurements& measurements) {
    switch (measure) {
    case Measure::rel: return measurements.rel;
    case Measure::abs: return measurements.abs;
    case Measure::flip: return at_compared(measurements.flip, images);
    case Measure::hdr_flip:
        if (measurements.hdr_flip.values.empty())
            throw Error("hdr_flip is for images of light (.exr, .hdr)", "use flip");
        return at_compared(measurements.hdr_flip, images);
    case Measure::z:
        if (!measurements.noise) throw Error("z needs a noise floor", "give one, or use rel");
        return measurements.noise->pixels;
    default: require(false, "only measures of pixels have pixel values"); return {};
    }
}

Verdict judge_by_pixel(const Tolerance& tolerance, const AlignedImages& images,
                       const Measurements& measurements) {
    const double limit = limit_of(tolerance, measurements);
    const PixelValues values = pixel_values(tolerance.measure, images, measurements);
    const auto over = std::ranges::count_if(values, [limit](float value) { return !(value <= limit); });
    const auto count = static_cast<double>(values.size());
    // A little slack: 1 - 0.98 is not quite 0.02.
    Verdict verdict{static_cast<double>(over) <= (1.0 - tolerance.quantile) * count + 1e-9 * count, {}};
    verdict.line = fmt::format("{} ≤ {:.4g} in {:.6g} % of the pixels: in {:.6g} %, largest {:.4g}",
                               name_of(tolerance.measure), limit, 100.0 * tolerance.quantile,
                               100.0 * (count - static_cast<double>(over)) / count,
                               static_cast<double>(std::ranges::max(values)));
    if (tolerance.measure != Measure::z) return verdict;
    const NoiseScores& noise = *measurements.noise;
    verdict.passed =
        verdict.passed && noise.max_block <= noise.limits.block && noise.total <= noise.limits.total;
    verdict.line += fmt::format("; of block sums {:.4g} (≤ {:.4g}), of the whole sum {:.4g} (≤ {:.4g})",
                                noise.max_block, noise.limits.block, noise.total, noise.limits.total);
    return verdict;
}

/// Σt/Σr of the channel that is furthest from 1.
double worst_energy_ratio(const Metrics& metrics) {
    return *std::ranges::max_element(metrics.energy_ratio, {}, [](double ratio) {
        return std::isnan(ratio) ? INFINITY : std::abs(ratio - 1.0);
    });
}

double image_value(Measure measure, const Measurements& measurements) {
    const Metrics& m = measurements.metrics;
    switch (measure) {
    case Measure::flip: return m.flip;
    case Measure::hdr_flip:
        if (measurements.hdr_flip.values.empty())
            throw Error("hdr_flip is for images of light (.exr, .hdr)", "use flip");
        return m.hdr_flip;
    case Measure::mean_rel: return m.mean_rel;
    case Measure::mean_abs: return m.mean_abs;
    case Measure::rmse: return m.rmse;
    case Measure::rel_mse: return m.rel_mse;
    case Measure::ssim: return m.ssim;
    case Measure::density: return m.density;
    case Measure::energy: return std::abs(worst_energy_ratio(m) - 1.0);
    default: require(false, "measures of pixels have no value for the image"); return 0.0;
    }
}

} // namespace

PixelValues errors_over_limits(const AlignedImages& images, const Measurements& measurements,
                               std::span<const Tolerance> tolerances) {
    PixelValues errors(images.compared.size(), 0.0f);
    for (const Tolerance& tolerance : tolerances) {
        if (!tolerance.by_pixel) continue;
        const double limit = limit_of(tolerance, measurements);
        const PixelValues values = pixel_values(tolerance.measure, images, measurements);
        for (std::size_t k = 0; k < values.size(); ++k)
            if (values[k] > 0.0f)
                errors[k] = std::max(errors[k], static_cast<float>(static_cast<double>(values[k]) / limit));
    }
    return errors;
}

Verdict judge(const Tolerance& tolerance, const AlignedImages& images, const Measurements& measurements) {
    if (tolerance.by_pixel) return judge_by_pixel(tolerance, images, measurements);
    const double value = image_value(tolerance.measure, measurements);
    switch (tolerance.measure) {
    case Measure::ssim: // NaN fails every one of these
        return {value >= tolerance.limit, fmt::format("ssim ≥ {:.6g}: {:.6g}", tolerance.limit, value)};
    case Measure::energy:
        return {value <= tolerance.limit,
                fmt::format("Σtest/Σreference within {:.4g} of 1: {:.6g}", tolerance.limit,
                            worst_energy_ratio(measurements.metrics))};
    case Measure::density:
        return {value <= tolerance.limit,
                fmt::format("failing pixels ≤ {:.4g} % of any 16x16 window: {:.4g} %",
                            100.0 * tolerance.limit, 100.0 * value)};
    default:
        return {value <= tolerance.limit,
                fmt::format("{} ≤ {:.4g}: {:.4g}", name_of(tolerance.measure), tolerance.limit, value)};
    }
}

} // namespace sr::compare
