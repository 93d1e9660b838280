#pragma once
// Samples where they are needed: looks at the error of a growing picture now and then, and lets pixels rest.
#include "render/renderer.hpp"

#include <limits>

namespace sr::render {

/// Whether an error is worth a look after `samples` samples: at 2^k and 3·2^k of them, from 8 on.
bool is_time_to_look(int samples);

class Convergence {
public:
    /// `target`: √relMSE that the picture shall keep under; 0: no pixel ever rests.
    explicit Convergence(double target) : target_(target) {}

    /// Looks at the renderer's error and sends the pixels that need no more samples to rest. The renderer has
    /// two samples at least.
    void look(Renderer& renderer);

    /// What was seen last; absent before the first look.
    const std::optional<ErrorEstimate>& seen() const { return seen_; }
    /// The estimate that counts: what was seen, but no less than the look before lets expect. Infinite at
    /// first.
    double error() const { return error_; }
    /// Never after one look alone.
    bool is_reached() const { return is_confirmed_ && error_ <= target_; }

private:
    double target_;
    std::optional<ErrorEstimate> seen_;
    double error_ = std::numeric_limits<double>::infinity();
    double last_error_ = 0.0;   // at the look before
    int samples_ = 0;           // at the look before
    bool is_confirmed_ = false; // there was a look before
    std::vector<float> blocks_; // at the look before: the mean square of each block
};

} // namespace sr::render
