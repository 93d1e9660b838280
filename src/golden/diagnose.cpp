#include "golden/diagnose.hpp"

#include "golden/layer.hpp"
#include "golden/mistakes.hpp"
#include "golden/screen.hpp"

#include <algorithm>
#include <cmath>

namespace sr::golden {
namespace {

using image::Image;

// "By far": a fifth of the difference is left, or a tenth where the pixels were chosen because they differ.
constexpr double largest_residual_whole = 0.2;
constexpr double largest_residual_failing = 0.1;
constexpr double as_good = 0.02; // residuals this near to the best explain as much

/// The least free of those that explain as much as the best does.
std::optional<Diagnosis> best_of(const Trials& trials, double largest_residual) {
    double least = largest_residual;
    for (const Trial& trial : trials) least = std::min(least, trial.diagnosis.residual);
    const Trial* best = nullptr;
    for (const Trial& trial : trials) {
        if (trial.diagnosis.residual > std::min(least + as_good, largest_residual)) continue;
        const auto rank = [](const Trial& t) { return std::pair(t.freedom, t.diagnosis.residual); };
        if (!best || rank(trial) < rank(*best)) best = &trial;
    }
    if (!best) return std::nullopt;
    return best->diagnosis;
}

} // namespace

std::optional<Diagnosis> diagnosed(const Pair& pair, const Comparison& comparison, const Image& reference,
                                   const CompareOptions& options) {
    const Evidence whole = whole_evidence(pair, options.encoding);
    if (whole.floor == 0.0f) return std::nullopt; // a black reference explains nothing
    Trials trials;
    try_blank(whole, trials);
    try_factors(whole, trials);
    try_curves(whole, trials);
    try_channel_orders(whole, trials);
    try_places(whole, trials);
    if (options.layer.empty() && options.encoding == Encoding::scene_referred)
        try_lights(whole, reference, trials);
    if (auto diagnosis = best_of(trials, largest_residual_whole)) return diagnosis;

    const auto failing = failing_evidence(whole, pair, comparison.error);
    if (!failing) return std::nullopt;
    Trials local;
    try_factors(*failing, local);
    try_curves(*failing, local);
    try_channel_orders(*failing, local);
    return best_of(local, largest_residual_failing);
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
    return best_of(trials, largest_residual_whole);
}

} // namespace sr::golden
