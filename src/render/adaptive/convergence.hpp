#pragma once
// Adaptive sampling: error estimates during a rendering, converged pixels, and the conditions that end it.
#include "render/renderer.hpp"

#include <limits>
#include <optional>

namespace sr::render {

/// True if the error is estimated after `samples` samples: after 2^k and 3·2^k of them, from 8 on.
bool is_estimate_due(int samples);

class Convergence {
public:
    /// `target`: √relMSE that the picture shall keep under; 0: no pixel is ever frozen.
    explicit Convergence(double target) : target_(target) {}

    /// Estimates the renderer's error and freezes the pixels that need no more samples. The renderer has
    /// two samples at least.
    void update(Renderer& renderer);

    /// The last estimate, averaged with those before it; absent before the first one.
    const std::optional<ErrorEstimate>& estimate() const { return estimate_; }
    /// Infinite before the first estimate.
    double error() const { return estimate_ ? estimate_->error : std::numeric_limits<double>::infinity(); }
    /// Never true after one estimate alone.
    bool is_reached() const { return is_confirmed_ && error() <= target_; }

private:
    /// Halves can agree by chance, all the more where samples are few and a pixel is half on an edge. So a
    /// pixel's square is the mean of what is seen and what was seen before, scaled as slowly as variance can
    /// fall.
    void remember(const std::vector<int>& samples);

    double target_;
    std::optional<ErrorEstimate> estimate_;
    bool is_confirmed_ = false;  // there was an estimate before
    std::vector<float> squares_; // of each pixel, by the estimate before
    std::vector<int> samples_;
};

/// Limit on the samples of a pixel where time or error ends a rendering.
inline constexpr int max_samples = 65536;

/// Conditions that end a rendering. The first one that is met ends it.
struct StopRule {
    int samples = 16;              // a pixel, at most
    std::optional<double> seconds; // of drawing
    std::optional<double> error;   // √relMSE, 0.005 for half a percent

    /// True if the error must be estimated, for which samples come from two sequences.
    bool asks_for_error() const { return seconds || error; }
};

enum class StoppedBy { samples, time, error, interruption };
const char* name_of(StoppedBy reason);

/// Progress of a rendering towards its stop rule, sample by sample.
class StopMonitor {
public:
    explicit StopMonitor(const StopRule& rule) : rule_(rule), convergence_(rule.error.value_or(0.0)) {}

    const StopRule& rule() const { return rule_; }
    /// Restarts for a rendering without samples.
    void restart();
    /// Takes note of a complete sample of `renderer`, which took `seconds`. Estimates the error when that is
    /// due, and freezes converged pixels. @return true if pixels may have been frozen
    bool took_sample(Renderer& renderer, double seconds);
    /// Estimates the error of the present samples, unless that is done or the renderer does not know it.
    void update_error(Renderer& renderer);

    /// The condition of the rule that is met; absent if the rendering goes on.
    std::optional<StoppedBy> stopped_by() const { return stopped_by_; }
    /// Time of all samples and estimates [s].
    double seconds() const { return seconds_; }
    /// The last estimate; absent before the first one.
    const std::optional<ErrorEstimate>& estimate() const { return convergence_.estimate(); }
    /// √relMSE of the last estimate; absent before the first one.
    std::optional<double> error() const;

private:
    std::optional<StoppedBy> condition_met(const Renderer& renderer, double last_seconds) const;

    StopRule rule_;
    Convergence convergence_;
    double seconds_ = 0.0;
    int estimated_at_ = 0; // samples
    std::optional<StoppedBy> stopped_by_;
};

} // namespace sr::render
