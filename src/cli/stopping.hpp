#pragma once
// When a picture has enough samples.
#include "cli/interruption.hpp"
#include "render/convergence.hpp"

#include <optional>
#include <string>

namespace sr::cli {

/// Samples a pixel where only --time or --error ends a rendering.
inline constexpr int most_samples = 65536;

/// What ends a rendering; whatever comes first.
struct StopRule {
    int samples = 16;              // a pixel, at most
    std::optional<double> seconds; // of drawing
    std::optional<double> error;   // √relMSE, 0.005 for half a percent

    bool asks_for_error() const { return seconds || error; }
};

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
