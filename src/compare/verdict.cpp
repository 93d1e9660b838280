#include "compare/verdict.hpp"

#include "compare/edges.hpp"
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

/// The difference that a limit allows from a value.
Slack slack_of(const Tolerance& tolerance, const AlignedImages& images, const Measurements& measurements) {
    const auto limit = static_cast<float>(limit_of(tolerance, measurements));
    const auto colors = static_cast<std::size_t>(images.colors);
    switch (tolerance.measure) {
    case Measure::rel:
        return [=, &floors = measurements.floors](std::size_t, std::size_t c, float value) {
            return limit * (c < colors ? std::max(std::abs(value), static_cast<float>(floors[c])) : 1.0f);
        };
    case Measure::z:
        return [=, &errors = measurements.noise->errors](std::size_t pixel, std::size_t c, float) {
            return c < colors ? limit * errors[pixel * colors + c] : 0.0f; // of Student's t it is no less
        };
    default: return [limit](std::size_t, std::size_t, float) { return limit; };
    }
}

std::vector<bool> over(const PixelValues& values, double limit) {
    std::vector<bool> fails;
    for (const float value : values) fails.push_back(!(static_cast<double>(value) <= limit));
    return fails;
}

/// "1 pixel exceeds it", "3 pixels exceed it".
std::string pixels_exceed(std::size_t count) {
    return fmt::format("{} {} it", count, count == 1 ? "pixel exceeds" : "pixels exceed");
}

Verdict judge_with_edges(const Tolerance& tolerance, const AlignedImages& images,
                         const Measurements& measurements) {
    const double limit = limit_of(tolerance, measurements);
    const PixelValues values = pixel_values(tolerance.measure, images, measurements);
    const EdgeJudgement edges =
        judge_edges(images, over(values, limit), slack_of(tolerance, images, measurements));
    Verdict verdict{edges.passes(), fmt::format("{} ≤ {:.4g}", name_of(tolerance.measure), limit)};
    const auto largest = static_cast<double>(std::ranges::max(values));
    if (edges.failing == 0)
        verdict.line += fmt::format(": largest {:.4g}", largest);
    else if (edges.failing > edges.max_count)
        verdict.line += fmt::format(": {} (at most {} may, at edges), largest {:.4g}",
                                    pixels_exceed(edges.failing), edges.max_count, largest);
    else if (edges.unexplained > 0)
        verdict.line += fmt::format(": {}, {} of them at no edge that moved, largest {:.4g}",
                                    pixels_exceed(edges.failing), edges.unexplained, largest);
    else
        verdict.line +=
            fmt::format(": {}, at edges that moved{}{}", pixels_exceed(edges.failing),
                        edges.is_crowded ? fmt::format(", more than {0} of them in a {1}x{1} window",
                                                       max_at_edges_nearby, edge_window)
                                         : "",
                        edges.is_in_line        ? ", at even distances in a row or column"
                        : edges.is_in_rectangle ? ", most of them at the corners of rectangles"
                        : edges.is_line_wrong   ? ", in a row or column that changed as a whole"
                                                : "");
    return verdict;
}

Verdict judge_with_quantile(const Tolerance& tolerance, const AlignedImages& images,
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
    return verdict;
}

Verdict judge_by_pixel(const Tolerance& tolerance, const AlignedImages& images,
                       const Measurements& measurements) {
    Verdict verdict = tolerance.forgives_edges ? judge_with_edges(tolerance, images, measurements)
                                               : judge_with_quantile(tolerance, images, measurements);
    if (tolerance.measure != Measure::z) return verdict;
    const NoiseScores& noise = *measurements.noise;
    verdict.passed = verdict.passed && (!noise.judges_blocks || noise.max_block <= noise.limits.block)
                     && noise.total <= noise.limits.total;
    if (noise.judges_blocks)
        verdict.line += fmt::format("; of block sums {:.4g} (≤ {:.4g})", noise.max_block, noise.limits.block);
    verdict.line += fmt::format("{} of the whole sum {:.4g} (≤ {:.4g})", noise.judges_blocks ? "," : ";",
                                noise.total, noise.limits.total);
    if (!noise.rare_events.empty())
        verdict.line += fmt::format("; {} left out as rare events",
                                    noise.rare_events.size() == 1
                                        ? "1 single pixel"
                                        : fmt::format("{} single pixels", noise.rare_events.size()));
    return verdict;
}

/// The energy ratio that is furthest from 1.
double worst_of(const std::vector<double>& ratios) {
    return *std::ranges::max_element(
        ratios, {}, [](double ratio) { return std::isnan(ratio) ? INFINITY : std::abs(ratio - 1.0); });
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
    case Measure::energy: return std::abs(worst_of(measurements.even_energy_ratios) - 1.0);
    default: require(false, "measures of pixels have no value for the image"); return 0.0;
    }
}

} // namespace

std::vector<bool> pixels_at_edges(const AlignedImages& images, const Measurements& measurements,
                                  std::span<const Tolerance> tolerances) {
    std::vector<bool> forgiven(images.compared.size(), false);
    for (const Tolerance& tolerance : tolerances) {
        if (!tolerance.forgives_edges) continue;
        const std::vector<bool> fails =
            over(pixel_values(tolerance.measure, images, measurements), limit_of(tolerance, measurements));
        if (judge_edges(images, fails, slack_of(tolerance, images, measurements)).passes())
            for (std::size_t k = 0; k < fails.size(); ++k) forgiven[k] = forgiven[k] || fails[k];
    }
    return forgiven;
}

PixelValues errors_over_limits(const AlignedImages& images, const Measurements& measurements,
                               std::span<const Tolerance> tolerances) {
    PixelValues errors(images.compared.size(), 0.0f);
    const std::vector<bool> forgiven = pixels_at_edges(images, measurements, tolerances);
    for (const Tolerance& tolerance : tolerances) {
        if (!tolerance.by_pixel) continue;
        const double limit = limit_of(tolerance, measurements);
        const PixelValues values = pixel_values(tolerance.measure, images, measurements);
        for (std::size_t k = 0; k < values.size(); ++k) {
            if (!(values[k] > 0.0f)) continue;
            const auto error = static_cast<float>(static_cast<double>(values[k]) / limit);
            errors[k] =
                std::max(errors[k], forgiven[k] && tolerance.forgives_edges ? std::min(error, 1.0f) : error);
        }
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
                            worst_of(measurements.even_energy_ratios))};
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
