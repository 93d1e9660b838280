#include "golden/compare.hpp"

#include "core/error.hpp"
#include "golden/density.hpp"
#include "golden/diagnose.hpp"
#include "golden/flip.hpp"
#include "golden/limits.hpp"
#include "golden/screen.hpp"
#include "golden/ssim.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace sr::golden {
namespace {

using image::Image;

constexpr const char* default_density = "density=0.25";

/// The given tolerances, or the default ones; wherever a share of the pixels may fail, they may not cluster.
std::vector<Tolerance> tolerances_in_use(const CompareOptions& options) {
    std::vector<Tolerance> tolerances = options.tolerances;
    if (tolerances.empty()) tolerances = default_tolerances(options.encoding, !options.noise.empty());
    const bool limits_density =
        std::ranges::any_of(tolerances, [](const Tolerance& t) { return t.measure == Measure::density; });
    const bool some_may_fail =
        std::ranges::any_of(tolerances, [](const Tolerance& t) { return t.quantile < 1.0; });
    if (some_may_fail && !limits_density) tolerances.push_back(parsed_tolerance(default_density));
    return tolerances;
}

/// Those that hold pixel by pixel, or the default ones, so that there is an error map in any case.
std::vector<Tolerance> pixel_tolerances(const std::vector<Tolerance>& tolerances,
                                        const CompareOptions& options) {
    if (std::ranges::any_of(tolerances, &Tolerance::by_pixel)) return tolerances;
    return default_tolerances(options.encoding, !options.noise.empty());
}

double mean_over(const Plane& plane, const Pair& pair) {
    double sum = 0.0;
    for (const std::size_t i : pair.compared) sum += static_cast<double>(plane.values[i]);
    return sum / static_cast<double>(pair.compared.size());
}

/// What people see: FLIP and SSIM.
void measure_appearance(const Pair& pair, const CompareOptions& options, Measured& measured) {
    const bool is_light = options.encoding == Encoding::scene_referred;
    const Screens shown = screens(pair.test, pair.reference, is_light);
    measured.flip = flip(screen_light(shown.test), screen_light(shown.reference), options.pixels_per_degree);
    measured.metrics.flip = mean_over(measured.flip, pair);
    measured.metrics.ssim = ssim(luma(shown.test), luma(shown.reference));
    if (!is_light) return;
    const Exposures exposures = options.exposures ? *options.exposures : exposures_for(pair.reference);
    measured.hdr_flip = hdr_flip(pair.test, pair.reference, exposures, options.pixels_per_degree);
    measured.metrics.hdr_flip = mean_over(measured.hdr_flip, pair);
}

Measured measure(const Pair& pair, const CompareOptions& options) {
    Measured measured;
    measure_differences(pair, measured.metrics);
    if (pair.compared.empty()) return measured;
    measured.abs = absolute_differences(pair);
    measured.rel = relative_differences(pair, measured.metrics.floor);
    if (!options.noise.empty()) {
        measured.noise = scored(pair, options.noise);
        measured.metrics.max_z = std::ranges::max(measured.noise->pixels);
        measured.metrics.max_block_z = measured.noise->max_block;
        measured.metrics.total_z = measured.noise->total;
    }
    measure_appearance(pair, options, measured);
    return measured;
}

/// The error map of Comparison.
Image error_map(const Pair& pair, const PixelValues& errors) {
    Image map(pair.reference.width, pair.reference.height, 1);
    for (std::size_t i = 0; i < pair.pixels.size(); ++i)
        map.pixels[i] = pair.pixels[i] == Pixel::nonfinite ? std::nanf("") : -1.0f;
    for (std::size_t k = 0; k < errors.size(); ++k) map.pixels[pair.compared[k]] = errors[k];
    return map;
}

Verdict judged_finite(const Pair& pair, bool nonfinite_is_allowed) {
    const std::size_t count = pair.nonfinite_test + pair.nonfinite_reference;
    return {count == 0 || nonfinite_is_allowed,
            fmt::format("finite pixels only: {} of the test and {} of the reference are not{}",
                        pair.nonfinite_test, pair.nonfinite_reference,
                        count > 0 && nonfinite_is_allowed ? ", which is allowed" : "")};
}

void judge(const Pair& pair, Measured& measured, const CompareOptions& options, Comparison& comparison) {
    comparison.verdicts.push_back(judged_finite(pair, options.allow_nonfinite));
    if (pair.compared.empty()) {
        comparison.verdicts.push_back({false, "something to compare: no pixel is finite in both images"});
        comparison.error = error_map(pair, {});
        return;
    }
    const auto tolerances = tolerances_in_use(options);
    const PixelValues errors = errors_over_limits(pair, measured, pixel_tolerances(tolerances, options));
    std::vector<bool> fails;
    for (const float error : errors) fails.push_back(!(error <= 1.0f));
    measured.metrics.failing_fraction =
        static_cast<double>(std::ranges::count(fails, true)) / static_cast<double>(fails.size());
    measured.metrics.density = densest_window(pair, fails);
    for (const Tolerance& tolerance : tolerances)
        comparison.verdicts.push_back(judged(tolerance, pair, measured));
    comparison.error = error_map(pair, errors);
}

} // namespace

std::vector<Tolerance> default_tolerances(Encoding encoding, bool noise_is_known) {
    if (noise_is_known) return {parsed_tolerance("z=auto@99.9%")};
    if (encoding == Encoding::display_referred)
        return {parsed_tolerance("abs=0.0079@99.9%"), parsed_tolerance("energy=0.01")};
    return {parsed_tolerance("rel=0.01@99.9%"), parsed_tolerance("energy=0.005")};
}

Comparison compare(const Image& test, const Image& reference, const CompareOptions& options) {
    Comparison comparison;
    const std::string difference = obstacle(test, reference, options.layer);
    if (!difference.empty()) {
        comparison.verdicts.push_back({false, "the same size and channels: " + difference});
        comparison.diagnosis = diagnosed_unequal_sizes(test, reference, options);
        return comparison;
    }
    const Pair pair = paired(test, reference, options);
    Measured measured = measure(pair, options);
    judge(pair, measured, options, comparison);
    comparison.passed = std::ranges::all_of(comparison.verdicts, &Verdict::passed);
    comparison.metrics = measured.metrics;
    if (!comparison.passed && !pair.compared.empty())
        comparison.diagnosis = diagnosed(pair, comparison, reference, options,
                                         measured.noise ? &measured.noise->pixels : nullptr);
    return comparison;
}

} // namespace sr::golden
