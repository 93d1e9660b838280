#pragma once
// How much of the resolution a moving picture can afford.
#include <algorithm>
#include <cmath>

namespace sr::viewer {

/// Chooses the scale of a picture's sides by what the frames before took: 1, or a power of 2^(-1/4) down to
/// an eighth. It shrinks when two frames in a row were too long (one may have been another program's), at
/// once when one was far too long, and grows when several in a row say that the next step would fit.
class Resolution {
public:
    /// `frame`: the seconds from one frame to the next that it aims at.
    explicit Resolution(double frame) : frame_(frame) {}

    float scale() const { return std::exp2(-0.25f * static_cast<float>(step_)); }

    /// What of a frame is not drawn at scale() [s], such as covering the window: it leaves the less for the
    /// rest.
    void others_took(double seconds) { others_ += 0.2 * (std::min(seconds, frame_) - others_); }
    /// What a sample at scale() may take [s].
    double budget() const { return std::max(frame_ - others_, least_share * frame_); }

    /// A sample at scale() took so long.
    void took(double seconds) {
        // A step halves the pixels' square root: time is taken to be proportional to pixels.
        const double excess = 2.0 * std::log2(std::max(seconds, 1e-6) / budget());
        if (excess > slack) {
            fitting_ = 0;
            const double certain = excess > far ? excess : std::min(excess, excess_before_);
            if (certain > slack) step_ = std::min(smallest, step_ + static_cast<int>(std::ceil(certain)));
            excess_before_ = certain > slack ? 0.0 : excess;
            return;
        }
        excess_before_ = 0.0;
        if (excess > -1.0 || step_ == 0) {
            fitting_ = 0;
        } else if (++fitting_ == frames_to_grow) {
            step_ = std::max(0, step_ + static_cast<int>(std::ceil(excess)));
            fitting_ = 0;
        }
    }

private:
    static constexpr int smallest = 12;
    static constexpr int frames_to_grow = 3;
    static constexpr double least_share = 0.3; // of a frame, that a sample has in any case
    static constexpr double slack =
        0.6;                           // [steps] over the budget, which is 1.23 times it: no reason to shrink
    static constexpr double far = 2.5; // [steps], which is 2.4 times the budget

    double frame_;
    double others_ = 0.0;
    double excess_before_ = 0.0;
    int step_ = 8; // a quarter: nothing is known yet
    int fitting_ = 0;
};

} // namespace sr::viewer
