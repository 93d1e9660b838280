// The light in the hand: taken by a handle or by a key, pulled, let go.
#include "viewer/session.hpp"

#include "viewer/handles.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <algorithm>

namespace sr::viewer {

/// Around what the selected light turns; the view's pivot for light that comes from infinitely far.
vec3 Session::grip_center() const {
    return center_of(show_->lighting(), *lights_.selected).value_or(eye_->view().pivot);
}

std::optional<Handles> Session::handles() const {
    const LightEditor& lighting = show_->lighting();
    if (!lights_.selected || !lighting.can_move(*lights_.selected)) return std::nullopt;
    const auto center = center_of(lighting, *lights_.selected);
    return handles_of(scene::sizes_of(lighting.lights_of(*lights_.selected).front()), grip_center(),
                      center.has_value(), projection(), ui_.scale());
}

void Session::take_grip(Verb verb, std::optional<int> axis, bool is_free) {
    const LightEditor& lighting = show_->lighting();
    Grip grip;
    grip.verb = verb;
    grip.is_free = is_free;
    grip.center = grip_center();
    grip.from = pointer_;
    grip.extents = scene::sizes_of(lighting.lights_of(*lights_.selected).front());
    if (axis) grip.constrain_to(*axis);
    grip_ = std::move(grip);
    show_->lighting().begin_step();
}

/// Shadows are made anew only for what casts some.
LightChange Session::change_of_grip() const {
    const scene::Light light = show_->lighting().lights_of(*lights_.selected).front();
    return is_scalable(light) ? LightChange::place : LightChange::quantity;
}

/// By a key: the light follows the pointer until a click.
void Session::take_grip(Verb verb) {
    if (!lights_.selected) return say("select a light first: click it, or press Tab");
    const LightEditor& lighting = show_->lighting();
    if (!lighting.can_move(*lights_.selected)) return say("surfaces belong to the scene: they stay");
    if (verb != Verb::turn && !center_of(lighting, *lights_.selected))
        return say("it shines from infinitely far: it can only be turned (R)");
    if (verb == Verb::scale && !is_scalable(lighting.lights_of(*lights_.selected).front()))
        return say("it is a point: a radius is to be given in its file");
    take_grip(verb, std::nullopt, true);
    say("X, Y, Z: along one axis; a number; click or Enter: done; Esc: as it was");
}

void Session::pull_grip(vec2 pointer) {
    if (!lights_.selected) return grip_.reset();
    LightEditor& lighting = show_->lighting();
    const bool snaps = input_.is_down(GLFW_KEY_LEFT_CONTROL) || input_.is_down(GLFW_KEY_RIGHT_CONTROL);
    const Pull pull = pulled(*grip_, projection(), pointer, snaps);
    lighting.restart_step();
    if (pull.size > 0.0f)
        lighting.set_size(*lights_.selected, static_cast<std::size_t>(*grip_->axis), pull.size);
    else
        lighting.transform(*lights_.selected, pull.transform);
    change_ = std::max(change_, change_of_grip());
    message_ = grip_->words = pull.words;
}

void Session::let_go(bool keeps) {
    const std::string words = std::exchange(grip_, std::nullopt)->words;
    if (words.empty()) return;
    if (keeps) return say(words);
    show_->lighting().cancel_step();
    change_ = std::max(change_, change_of_grip());
    say("it is as it was");
}

/// @return whether the event was about the light in the hand
bool Session::handle_grip(const Event& event) {
    if (const auto* motion = std::get_if<MotionEvent>(&event)) {
        pointer_ = motion->to;
        if (grip_) pull_grip(pointer_);
        return grip_.has_value();
    }
    const auto* button = std::get_if<ButtonEvent>(&event);
    if (!button) return grip_.has_value();
    if (grip_) {
        const bool ends = grip_->is_free == button->is_down;
        if (ends) let_go(button->button == Button::left);
        return true;
    }
    if (button->button != Button::left || !button->is_down || button->modifiers != no_modifier) return false;
    const auto all = handles();
    const auto handle = all ? handle_under(pointer_, *all) : std::nullopt;
    if (handle) take_grip(handle->verb, handle->axis, false);
    return handle.has_value();
}

/// Keys of the light in the hand; all others wait. @return whether one is in it
bool Session::handle_grip(const KeyEvent& event) {
    if (!grip_) return false;
    if (event.key == GLFW_KEY_ESCAPE) {
        let_go(false);
        return true;
    }
    if (event.key == GLFW_KEY_ENTER || event.key == GLFW_KEY_KP_ENTER) {
        let_go(true);
        return true;
    }
    const int axis = event.key - GLFW_KEY_X;
    if (axis >= 0 && axis < 3)
        grip_->constrain_to(axis);
    else if (!type_digit(grip_->typed, event.key))
        return true;
    pull_grip(pointer_);
    return true;
}

/// The handles of the selected light, and what is done to it.
void Session::draw_grip() const {
    const auto all = handles();
    if (!all) return;
    const auto held = grip_ && grip_->axis ? std::optional(Handle{grip_->verb, *grip_->axis}) : std::nullopt;
    viewer::draw(*all, held, ui_.scale());
    if (grip_) draw_words(grip_->words, pointer_, ui_.scale());
}

} // namespace sr::viewer
