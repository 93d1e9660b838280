#pragma once
// How much of the resolution a moving picture can afford.
#include <algorithm>
#include <cmath>

namespace sr::viewer {

/// Chooses the scale of a picture's sides by what the frames before took: 1, or a power of 2^(-1/4) down to
/// an eighth. It shrinks at once, and grows when several frames in a row say that the next step would fit.
class Resolution {
public:
    /// `budget`: the seconds that a frame may take.
    explicit Resolution(double budget) : budget_(budget) {}

    float scale() const { return std::exp2(-0.25f * static_cast<float>(step_)); }

    /// A frame at scale() took so long.
    void took(double seconds) {
        // A step halves the pixels' square root: time is taken to be proportional to pixels.
        const double excess = 2.0 * std::log2(std::max(seconds, 1e-6) / budget_);
        if (excess > 0.0) {
            step_ = std::min(smallest, step_ + static_cast<int>(std::ceil(excess)));
            fitting_ = 0;
        } else if (excess < -1.3 && step_ > 0) {
            if (++fitting_ < frames_to_grow) return;
            step_ = std::max(0, step_ - std::max(1, static_cast<int>(-excess - 0.3)));
            fitting_ = 0;
        } else {
            fitting_ = 0;
        }
    }

private:
    static constexpr int smallest = 12;
    static constexpr int frames_to_grow = 3;

    double budget_;
    int step_ = 8; // a quarter: nothing is known yet
    int fitting_ = 0;
};

} // namespace sr::viewer
