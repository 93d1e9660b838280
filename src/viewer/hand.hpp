#pragma once
// The pointer on the picture: drags, wheel and trackpad move the viewpoint, a click is a question.
#include "viewer/input.hpp"
#include "viewer/viewpoint.hpp"

#include <functional>

namespace sr::viewer {

class Hand {
public:
    /// With inertia what is let go while it moves goes on for a moment.
    explicit Hand(bool has_inertia = false) : has_inertia_(has_inertia) {}

    /// The surface under a place of the window; absent: nothing is there.
    using PointUnder = std::function<std::optional<vec3>(vec2)>;

    struct Effect {
        bool has_moved = false;
        std::optional<vec2> clicked; // a press and release of the left button in one place
    };

    /// `window`: its size, in the unit of the events.
    Effect take(const Event& event, Viewpoint& view, vec2 window, const PointUnder& point_under);

    /// To be called once a frame. @return whether the view went on by itself
    bool advance(double seconds, Viewpoint& view);

    bool is_gliding() const { return gliding_ != Drag::none; }
    bool is_dragging() const { return drag_ != Drag::none; }
    bool is_flying() const { return drag_ == Drag::look; }

private:
    enum class Drag { none, orbit, pan, dolly, look };
    static Drag drag_of(const ButtonEvent& press);

    static void drag(Drag how, vec2 by, Viewpoint& view);
    void press(const ButtonEvent& event);
    Effect move(vec2 to, Viewpoint& view, vec2 window);
    Effect scroll(const ScrollEvent& event, Viewpoint& view, const std::optional<vec3>& target);

    Drag drag_ = Drag::none;
    Button button_{};
    vec2 at_{0.0f};
    vec2 pressed_at_{0.0f};
    bool is_click_ = false; // so far, the drag is none
    bool has_inertia_;
    Drag gliding_ = Drag::none;
    vec2 travelled_{0.0f}; // since the last frame [heights of the window]
    vec2 velocity_{0.0f};  // [heights of the window / s]
};

/// One step of a flight: `toward` along the camera's axes (x right, y up, z back), at most one each.
void fly(Viewpoint& view, vec3 toward, float metres);

} // namespace sr::viewer
