#pragma once
// Samples until a picture has enough of them.
#include "cli/interruption.hpp"
#include "render/adaptive/convergence.hpp"
#include "render/adaptive/stop_rule.hpp"

#include <optional>
#include <string>

namespace sr::cli {

using render::most_samples;
using render::StopRule;

enum class StoppedBy { samples, time, error, interruption };
const char* name_of(StoppedBy reason);

struct Stop {
    StoppedBy by = StoppedBy::samples;
    std::optional<double>
        error; // what counted in the end; absent if the renderer does not know or cannot tell
    std::optional<render::ErrorEstimate> estimate; // in the end, whatever was seen before
};

/// Adds samples until the rule or the interruption ends it, with a bar on stderr. At least one is taken. The
/// renderer knows its error if the rule asks for it.
Stop add_samples(render::Renderer& renderer, const StopRule& rule, const Interruption& interruption,
                 const std::string& what);

/// Adds the samples again that the renderer had before repeat(): `count` of them. @return whether all were
/// added, and no interruption came.
bool add_again(render::Renderer& renderer, int count, const Interruption& interruption,
               const std::string& what);

} // namespace sr::cli
