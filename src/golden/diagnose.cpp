#include "golden/diagnose.hpp"

#include "golden/layer.hpp"
#include "golden/mistakes.hpp"
#include "golden/screen.hpp"

#include <algorithm>
#include <utility>

namespace sr::golden {
namespace {

using image::Image;

// "By far": a fifth of the difference is left, or a tenth where there is more freedom: numbers are fitted, or
// the pixels were chosen because they differ.
constexpr double largest_residual = 0.2;
constexpr double largest_residual_of_fits = 0.1;
constexpr int most_freedom_without_fits = 2;
// Pixels chosen because noise does not explain them differ by more than the mistake itself: what is fitted
// there is wrong, what has nothing to fit is not.
constexpr std::size_t fewest_significant = 32;
constexpr double as_good = 0.02; // residuals this near to the best explain as much

bool explains(const Trial& trial) {
    const bool fits = trial.freedom > most_freedom_without_fits;
    return trial.diagnosis.residual <= (fits ? largest_residual_of_fits : largest_residual);
}

/// The least free of those that explain as much as the best does.
std::optional<Diagnosis> best_of(Trials trials) {
    std::erase_if(trials, [](const Trial& trial) { return !explains(trial); });
    if (trials.empty()) return std::nullopt;
    const auto residual_of = [](const Trial& trial) { return trial.diagnosis.residual; };
    const double least = residual_of(std::ranges::min(trials, {}, residual_of));
    std::erase_if(trials, [&](const Trial& trial) { return residual_of(trial) > least + as_good; });
    return std::ranges::min(trials, {}, [&](const Trial& t) { return std::pair(t.freedom, residual_of(t)); })
        .diagnosis;
}

} // namespace

std::optional<Diagnosis> diagnosed(const Pair& pair, const Comparison& comparison, const Image& reference,
                                   const CompareOptions& options, const PixelValues* z) {
    const Evidence whole = whole_evidence(pair, options.encoding, z);
    if (whole.floor == 0.0f) return std::nullopt; // a black reference explains nothing
    if (z && whole.pixels.size() < fewest_significant) return std::nullopt;
    Trials trials;
    try_blank(whole, trials);
    try_factors(whole, trials);
    try_curves(whole, trials);
    try_channel_orders(whole, trials);
    try_places(whole, trials);
    if (options.layer.empty() && options.encoding == Encoding::scene_referred) {
        try_lights(whole, reference, trials);
        try_terms(whole, reference, trials);
    }
    if (z)
        std::erase_if(trials, [](const Trial& trial) { return trial.freedom > most_freedom_without_fits; });
    if (auto diagnosis = best_of(trials); diagnosis || z) return diagnosis;

    const auto failing = failing_evidence(whole, pair, comparison.error);
    if (!failing) return std::nullopt;
    Trials local;
    try_factors(*failing, local);
    try_curves(*failing, local);
    try_channel_orders(*failing, local);
    std::erase_if(local,
                  [](const Trial& trial) { return trial.diagnosis.residual > largest_residual_of_fits; });
    return best_of(local);
}

std::optional<Diagnosis> diagnosed_unequal_sizes(const Image& test, const Image& reference,
                                                 const CompareOptions& options) {
    if (test.width != reference.height || test.height != reference.width) return std::nullopt;
    const auto test_layer = layer_of(test, options.layer),
               reference_layer = layer_of(reference, options.layer);
    if (!test_layer || !reference_layer || test_layer->colors.size() != reference_layer->colors.size())
        return std::nullopt;
    const Image t = extracted(test, test_layer->colors), r = extracted(reference, reference_layer->colors);
    Trials trials;
    try_turned(t, r, trials);
    return best_of(trials);
}

} // namespace sr::golden
