#pragma once
// Exposure for a window: a given EV100, or an automatic one that follows the picture without flicker.
#include <cmath>
#include <optional>

namespace sr::viewer {

class Exposure {
public:
    /// Absent: automatic.
    explicit Exposure(std::optional<float> ev100) : fixed_(ev100), shown_(ev100.value_or(0.0f)) {}

    bool is_automatic() const { return !fixed_; }
    float ev100() const { return shown_; }

    void fix(float ev100) {
        fixed_ = shown_ = ev100;
        wanted_ = ev100;
    }
    void make_automatic() { fixed_.reset(); }

    /// What the picture at hand asks for. The first one counts at once, the others come smoothly.
    void measured(float ev100) {
        wanted_ = ev100;
        if (!has_measured_ && is_automatic()) shown_ = ev100;
        has_measured_ = true;
    }
    /// Another scene: its first picture counts at once again.
    void forget() { has_measured_ = false; }

    /// Moves on by so many seconds. @return whether the exposure still changes
    bool advance(double seconds) {
        if (!is_automatic() || shown_ == wanted_) return false;
        constexpr double half_life = 0.1; // [s]
        shown_ += (wanted_ - shown_) * static_cast<float>(1.0 - std::exp2(-seconds / half_life));
        if (std::abs(shown_ - wanted_) < 0.01f) shown_ = wanted_; // a hundredth of a stop is not seen
        return true;
    }

private:
    std::optional<float> fixed_;
    float shown_;
    float wanted_ = 0.0f;
    bool has_measured_ = false;
};

} // namespace sr::viewer
