#include "viewer/hand.hpp"

#include <algorithm>
#include <cmath>

namespace sr::viewer {
namespace {

constexpr float click_slack = 4.0f;   // a hand trembles so many pixels
constexpr float turn_per_height = pi; // [rad] of a drag over the window's height
constexpr float notch = 0.9f;         // a wheel's notch brings so much closer
constexpr float pan_per_notch = 0.05f;
constexpr float memory = 0.03f;          // [s] over which a hand's velocity is told
constexpr float glide_half_life = 0.12f; // [s]
constexpr float slowest_glide = 0.01f;   // [heights of the window / s]
constexpr float longest_step = 0.2f;     // [s] a frame that took longer does not throw the view

} // namespace

Hand::Drag Hand::drag_of(const ButtonEvent& press) {
    if (press.modifiers & alt) // Maya
        return press.button == Button::left     ? Drag::orbit
               : press.button == Button::middle ? Drag::pan
                                                : Drag::dolly;
    if (press.button == Button::right) return Drag::look;
    if (press.modifiers & shift) return Drag::pan; // Blender
    if (press.modifiers & control) return Drag::dolly;
    return Drag::orbit;
}

void Hand::press(const ButtonEvent& event) {
    drag_ = drag_of(event);
    button_ = event.button;
    pressed_at_ = at_;
    is_click_ = event.button == Button::left && event.modifiers == no_modifier;
    gliding_ = Drag::none;
    travelled_ = velocity_ = vec2(0.0f);
}

void Hand::drag(Drag how, vec2 by, Viewpoint& view) {
    switch (how) {
    case Drag::orbit: return orbit(view, turn_per_height * by);
    case Drag::look: return look_around(view, 0.5f * turn_per_height * by);
    case Drag::pan: return pan(view, by);
    case Drag::dolly: return dolly(view, std::exp2(3.0f * by.y));
    case Drag::none: return;
    }
}

Hand::Effect Hand::move(vec2 to, Viewpoint& view, vec2 window) {
    const vec2 by = (to - at_) / window.y;
    at_ = to;
    if (drag_ == Drag::none) return {};
    if (is_click_ && glm::distance(to, pressed_at_) <= click_slack) return {};
    is_click_ = false;
    drag(drag_, by, view);
    travelled_ += by;
    return {true, {}};
}

bool Hand::advance(double seconds, Viewpoint& view) {
    const auto elapsed = static_cast<float>(seconds);
    if (is_dragging() && elapsed > 0.0f) {
        velocity_ = glm::mix(travelled_ / elapsed, velocity_, std::exp2(-elapsed / memory));
        travelled_ = vec2(0.0f);
    }
    if (!is_gliding()) return false;
    velocity_ *= std::exp2(-elapsed / glide_half_life);
    if (glm::length(velocity_) < slowest_glide) {
        gliding_ = Drag::none;
        return false;
    }
    drag(gliding_, std::min(elapsed, longest_step) * velocity_, view);
    return true;
}

Hand::Effect Hand::scroll(const ScrollEvent& event, Viewpoint& view, const std::optional<vec3>& target) {
    gliding_ = Drag::none;
    if (event.by.x != 0.0f || (event.modifiers & shift))
        pan(view,
            pan_per_notch * ((event.modifiers & shift) ? vec2(event.by.x, event.by.y) : vec2(event.by.x, 0)));
    if (event.by.y == 0.0f || (event.modifiers & shift)) return {true, {}};
    const float factor = std::pow(notch, event.by.y);
    if (target)
        dolly_to(view, factor, *target);
    else
        dolly(view, factor);
    return {true, {}};
}

Hand::Effect Hand::take(const Event& event, Viewpoint& view, vec2 window, const PointUnder& point_under) {
    if (const auto* motion = std::get_if<MotionEvent>(&event)) return move(motion->to, view, window);
    if (const auto* wheel = std::get_if<ScrollEvent>(&event)) return scroll(*wheel, view, point_under(at_));
    const auto* button = std::get_if<ButtonEvent>(&event);
    if (!button) return {};
    if (button->is_down) {
        if (drag_ == Drag::none) press(*button);
        return {};
    }
    if (drag_ == Drag::none || button->button != button_) return {};
    if (has_inertia_ && !is_click_) gliding_ = drag_;
    drag_ = Drag::none;
    return is_click_ ? Effect{false, at_} : Effect{};
}

void fly(Viewpoint& view, vec3 toward, float metres) {
    if (toward != vec3(0.0f)) walk(view, metres * glm::normalize(toward));
}

} // namespace sr::viewer
