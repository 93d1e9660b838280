#pragma once
// Sampling loops of `steradian render`, with a progress bar.
#include "cli/interruption.hpp"
#include "render/adaptive/convergence.hpp"

#include <optional>
#include <string>

namespace sr::cli {

using render::most_samples;
using render::StoppedBy;
using render::StopRule;

struct Stop {
    StoppedBy by = StoppedBy::samples;
    std::optional<double> error;                   // √relMSE; absent if the renderer does not know it
    std::optional<render::ErrorEstimate> estimate; // of the final samples
};

/// Adds samples, at least one, until the rule or the interruption ends it. The renderer knows its error if
/// the rule needs it.
Stop add_samples(render::Renderer& renderer, const StopRule& rule, const Interruption& interruption,
                 const std::string& what);

/// Repeats the `count` samples that the renderer had before repeat(). @return false after an interruption
bool add_again(render::Renderer& renderer, int count, const Interruption& interruption,
               const std::string& what);

} // namespace sr::cli
