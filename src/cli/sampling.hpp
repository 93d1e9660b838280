#pragma once
// Sampling loops of `steradian render`, with a progress bar.
#include "render/adaptive/convergence.hpp"

#include <optional>
#include <stop_token>
#include <string>

namespace sr::cli {

using render::max_samples;
using render::StoppedBy;
using render::StopRule;

struct Stop {
    StoppedBy by = StoppedBy::samples;
    std::optional<double> error;                   // √relMSE; absent if the renderer does not know it
    std::optional<render::ErrorEstimate> estimate; // of the final samples
};

/// Adds samples, at least one, until the rule or a stop ends it. The renderer knows its error if
/// the rule needs it.
Stop add_samples(render::Renderer& renderer, const StopRule& rule, const std::stop_token& stop,
                 const std::string& what);

/// Repeats the `count` samples that the renderer had before repeat(). @return false if it was stopped
bool add_again(render::Renderer& renderer, int count, const std::stop_token& stop, const std::string& what);

} // namespace sr::cli
