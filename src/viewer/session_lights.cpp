// Editing lights: what is selected, dragged, switched, typed.
#include "viewer/session.hpp"

#include "viewer/pick.hpp"

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>

namespace sr::viewer {

Projection Session::projection() const { return {eye_->camera(), eye_->aspect_ratio(), window_size()}; }

/// Selects the light under the pointer: its mark, or its surface.
void Session::click(vec2 at) {
    const Lighting& lighting = show_->lighting();
    lights_.selected = LightsPanel::mark_under(lighting, projection(), at);
    if (!lights_.selected) {
        const scene::Stage& stage = show_->scene().stage;
        if (const auto hit = first_hit(stage.scene, projection().ray(at)))
            lights_.selected = lighting.lamp_of_instance(stage, hit->instance);
    }
    if (!lights_.selected) {
        question_ = at;
        say("asking the pixel; Esc stops");
        return;
    }
    say("selected " + lighting.lamps()[*lights_.selected].name);
}

/// Moves the selected light along the arrow that the pointer took. @return whether the event was about that
bool Session::drag_arrow(const Event& event) {
    if (const auto* button = std::get_if<ButtonEvent>(&event); button && button->button == Button::left) {
        const bool was_dragging = arrow_.has_value();
        arrow_.reset();
        if (!button->is_down || button->modifiers != no_modifier) return was_dragging;
        if (!lights_.selected || !show_->lighting().can_move(*lights_.selected)) return false;
        const auto center = center_of(show_->lighting(), *lights_.selected);
        const auto arrows = center ? arrows_at(*center, projection(), 70.0f * ui_.scale()) : std::nullopt;
        if (!arrows) return false;
        const vec2 pointer = input_.pointer();
        arrow_ = axis_under(pointer, *arrows);
        if (!arrow_) return false;
        arrow_at_ = along_axis(*center, *arrow_, projection().ray(pointer));
        show_->lighting().begin_step();
        return true;
    }
    const auto* motion = std::get_if<MotionEvent>(&event);
    if (!motion || !arrow_) return false;
    const auto center = center_of(show_->lighting(), *lights_.selected);
    if (!center) return true;
    vec3 by(0.0f);
    by[*arrow_] = along_axis(*center, *arrow_, projection().ray(motion->to)) - arrow_at_;
    show_->lighting().transform(*lights_.selected, glm::translate(mat4(1.0f), by));
    show_->relight(true);
    return true;
}

bool Session::obey_light(Command command) {
    Lighting& lighting = show_->lighting();
    const std::size_t count = lighting.lamps().size();
    const auto changed = [&](LightChange change) { change_ = std::max(change_, change); };
    if (command == Command::next_light) {
        if (count > 0) lights_.selected = lights_.selected ? (*lights_.selected + 1) % count : 0;
        return true;
    }
    if (command == Command::undo_light) {
        if (lighting.undo())
            changed(LightChange::place);
        else
            say("nothing to undo");
        return true;
    }
    if (command != Command::edit_light && command != Command::switch_light && command != Command::solo_light
        && command != Command::delete_light)
        return false;
    if (!lights_.selected) {
        say("select a light first: click it, or press Tab");
        return true;
    }
    const std::size_t lamp = *lights_.selected;
    lighting.begin_step();
    if (command == Command::edit_light) lights_.edit();
    if (command == Command::switch_light) {
        lighting.switch_to(lamp, !lighting.lamps()[lamp].is_on);
        changed(LightChange::quantity);
    }
    if (command == Command::solo_light) {
        lighting.solo(lamp);
        changed(LightChange::quantity);
    }
    if (command == Command::delete_light) {
        if (lighting.remove(lamp))
            lights_.selected.reset();
        else
            say("surfaces belong to the scene: it is switched off");
        changed(LightChange::place);
    }
    return true;
}

scene::Bounds Session::selection() const {
    scene::Bounds bounds;
    if (!lights_.selected) return bounds;
    const float least = eye_->bounds().is_empty() ? 0.1f : 0.02f * eye_->bounds().radius();
    for (const scene::Light& light : show_->lighting().lights_of(*lights_.selected)) {
        const scene::Bounds one = bounds_of(light, least);
        if (one.is_empty()) continue;
        bounds.extend(one.min);
        bounds.extend(one.max);
    }
    return bounds;
}

void Session::draw_lights() {
    std::string message;
    const LightChange change = lights_.draw(show_->lighting(), show_->scene(), eye_->view().pivot, message);
    change_ = std::max(change_, change);
    if (!message.empty()) say(message);
}

/// What was changed since the last frame comes into the picture.
void Session::relight() {
    if (change_ == LightChange::none) return;
    show_->relight(change_ == LightChange::place);
    change_ = LightChange::none;
    probe_.answer.reset();
    measured_samples_ = 0;
}

} // namespace sr::viewer
