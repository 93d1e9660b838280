#pragma once
// Conditions under which a picture has enough samples.
#include <optional>

namespace sr::render {

/// Samples a pixel where only time or error ends a rendering.
inline constexpr int max_samples = 65536;

/// Conditions that end a rendering. The first one that is met ends it.
struct StopRule {
    int samples = 16;              // a pixel, at most
    std::optional<double> seconds; // of drawing
    std::optional<double> error;   // √relMSE, 0.005 for half a percent

    /// True if the picture has to know its error. It then takes its samples from two sequences.
    bool asks_for_error() const { return seconds || error; }
};

} // namespace sr::render
