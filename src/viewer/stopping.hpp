#pragma once
// When a standing picture is done: by the same rules as `steradian render`, sample by sample.
#include "render/convergence.hpp"
#include "render/stop_rule.hpp"

namespace sr::viewer {

class Stopping {
public:
    explicit Stopping(const render::StopRule& rule) : rule_(rule), convergence_(rule.error.value_or(0.0)) {}

    const render::StopRule& rule() const { return rule_; }

    /// A picture without samples.
    void begin();

    /// A sample of `renderer` is complete, which took so many seconds. Looks at the error when that is due,
    /// and sends pixels to rest. @return whether that may have changed which ones rest
    bool took_sample(render::Renderer& renderer, double seconds);

    /// Nothing more is to be added.
    bool is_done() const { return is_done_; }

    /// √relMSE as it was last seen; absent before the first look, and where nobody asked for it.
    std::optional<double> error() const;

private:
    void look(render::Renderer& renderer);
    bool is_enough(const render::Renderer& renderer, double seconds) const;

    render::StopRule rule_;
    render::Convergence convergence_;
    double spent_ = 0.0; // [s]
    int looked_at_ = 0;  // samples
    bool is_done_ = false;
};

} // namespace sr::viewer
