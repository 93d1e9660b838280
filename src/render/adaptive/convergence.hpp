#pragma once
// Samples where they are needed: looks at the error of a growing picture now and then, and lets pixels rest.
#include "render/adaptive/stop_rule.hpp"
#include "render/renderer.hpp"

#include <limits>

namespace sr::render {

/// True if the error is estimated after `samples` samples: after 2^k and 3·2^k of them, from 8 on.
bool is_time_to_look(int samples);

class Convergence {
public:
    /// `target`: √relMSE that the picture shall keep under; 0: no pixel ever rests.
    explicit Convergence(double target) : target_(target) {}

    /// Looks at the renderer's error and sends the pixels that need no more samples to rest. The renderer has
    /// two samples at least.
    void look(Renderer& renderer);

    /// The last estimate, averaged with those before it; absent before the first look.
    const std::optional<ErrorEstimate>& seen() const { return seen_; }
    /// Infinite before the first look.
    double error() const { return seen_ ? seen_->error : std::numeric_limits<double>::infinity(); }
    /// Never after one look alone.
    bool is_reached() const { return is_confirmed_ && error() <= target_; }

private:
    /// Halves can agree by chance, all the more where samples are few and a pixel is half on an edge. So a
    /// pixel's square is the mean of what is seen and what was seen before, scaled as slowly as variance can
    /// fall.
    void remember(const std::vector<int>& samples);
    PixelMask enough() const; // the pixels that may rest

    double target_;
    std::optional<ErrorEstimate> seen_;
    bool is_confirmed_ = false;  // there was a look before
    std::vector<float> squares_; // at the look before: of each pixel
    std::vector<int> samples_;
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
    const std::optional<ErrorEstimate>& estimate() const { return convergence_.seen(); }
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
