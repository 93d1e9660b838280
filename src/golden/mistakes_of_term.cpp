#include "golden/layer.hpp"
#include "golden/mistakes.hpp"

#include <algorithm>
#include <array>

namespace sr::golden {
namespace {

struct Term {
    const char* channel;
    const char* mistake;
    const char* line;
};

constexpr std::array terms{
    Term{"visibility.V", "shadows_missing", "test = reference / V: its shadows are missing"},
    Term{"cosine.cos", "cosine_missing", "test = reference / cosθ: the cosine is missing"},
};

/// A term below this is too small, or too noisy, to tell what was divided by it.
constexpr float least = 0.05f;
/// A term that is 1 nearly everywhere explains nothing.
constexpr double fewest_changed = 0.01;

} // namespace

void try_terms(const Evidence& e, const image::Image& reference, Trials& trials) {
    for (const Term& term : terms) {
        const auto channel = std::ranges::find(reference.channel_names, term.channel);
        if (channel == reference.channel_names.end()) continue;
        const std::vector<float> values =
            extracted(reference, {static_cast<int>(channel - reference.channel_names.begin())}).pixels;
        const auto changed = std::ranges::count_if(
            e.pixels, [&](std::size_t i) { return values[i] >= least && values[i] < 0.95f; });
        if (static_cast<double>(changed) < fewest_changed * static_cast<double>(e.pixels.size())) continue;
        const double rest = residual(e, [&](std::size_t i, std::size_t c) {
            return values[i] >= least ? e.r(i, c) / values[i] : unknown;
        });
        trials.push_back({{term.mistake, term.line, rest, {}}, 2});
    }
}

} // namespace sr::golden
