#pragma once
// Exposure of the window: a fixed EV100, or an automatic one that follows the picture without flicker.
#include "image/display.hpp"
#include "viewer/view/progressive_render.hpp"

#include <bit>
#include <cmath>
#include <optional>
#include <utility>

namespace sr::viewer {

class Exposure {
public:
    /// `ev100`: absent for automatic exposure.
    explicit Exposure(std::optional<float> ev100) : fixed_(ev100), shown_(ev100.value_or(0.0f)) {}

    bool is_automatic() const { return !fixed_; }
    float ev100() const { return shown_; }

    void fix(float ev100) { fixed_ = shown_ = target_ = ev100; }
    void make_automatic() { fixed_.reset(); }
    /// Another scene: its first measurement applies at once.
    void restart() { has_measured_ = false; }

    /// Measures the picture if that is due. Reading the film back is slow, so an interactive render is
    /// measured every eighth frame and a converging one at sample number 1, 2, 4, … and when it has
    /// converged.
    void measure(const ProgressiveRender& render, int frame) {
        const int samples = render.sample_count();
        if (render.is_interactive()) measured_samples_ = 0;
        if (!is_automatic() || samples == 0) return;
        const bool is_due = render.is_interactive() ? frame % 8 == 0
                                                    : std::has_single_bit(static_cast<unsigned>(samples))
                                                          || render.is_converged();
        if (!is_due || samples == measured_samples_) return;
        if (!render.is_interactive()) measured_samples_ = samples;
        target_ = image::auto_ev100(render.read_film());
        if (!std::exchange(has_measured_, true)) shown_ = target_;
    }

    /// Approaches the last measurement for so many seconds. @return true if the exposure changes
    bool advance(double seconds) {
        if (!is_automatic() || shown_ == target_) return false;
        constexpr double half_life = 0.1; // [s]
        shown_ += (target_ - shown_) * static_cast<float>(1.0 - std::exp2(-seconds / half_life));
        if (std::abs(shown_ - target_) < 0.01f) shown_ = target_; // a hundredth of a stop is invisible
        return true;
    }

private:
    std::optional<float> fixed_;
    float shown_;
    float target_ = 0.0f;
    bool has_measured_ = false;
    int measured_samples_ = 0; // of the converging render
};

} // namespace sr::viewer
