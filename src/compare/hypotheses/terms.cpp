#include "compare/align.hpp"
#include "compare/hypotheses/hypothesis.hpp"

#include <algorithm>
#include <array>

namespace sr::compare {
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
constexpr float min_term = 0.05f;
/// A term that is 1 nearly everywhere explains nothing.
constexpr double min_changed = 0.01;

} // namespace

void hypotheses_terms(const DiagnosisInput& in, const image::Image& reference, Hypotheses& out) {
    for (const Term& term : terms) {
        const auto channel = std::ranges::find(reference.channel_names, term.channel);
        if (channel == reference.channel_names.end()) continue;
        const std::vector<float> values =
            extract(reference, {static_cast<int>(channel - reference.channel_names.begin())}).pixels;
        const auto changed = std::ranges::count_if(
            in.pixels, [&](std::size_t i) { return values[i] >= min_term && values[i] < 0.95f; });
        if (static_cast<double>(changed) < min_changed * static_cast<double>(in.pixels.size())) continue;
        const double left = residual(in, [&](std::size_t i, std::size_t c) {
            return values[i] >= min_term ? in.r(i, c) / values[i] : unknown;
        });
        out.push_back({{term.mistake, term.line, left, {}}, 2});
    }
}

} // namespace sr::compare
