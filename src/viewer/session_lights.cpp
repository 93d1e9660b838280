// Editing lights: what is selected, dragged, switched, typed.
#include "viewer/session.hpp"

#include "viewer/pick.hpp"

#include <algorithm>

namespace sr::viewer {

Projection Session::projection() const { return {eye_->camera(), eye_->aspect_ratio(), window_size()}; }

/// Selects the light under the pointer: its mark, or its surface.
void Session::click(vec2 at) {
    const LightEditor& lighting = show_->lighting();
    lights_.selected = LightsPanel::mark_under(lighting, projection(), at);
    if (!lights_.selected) {
        const scene::Stage& stage = show_->scene().stage;
        if (const auto hit = first_hit(stage.scene, projection().ray(at)))
            lights_.selected = lighting.entry_of_instance(stage, hit->instance);
    }
    if (!lights_.selected) {
        question_ = at;
        say("asking the pixel; Esc stops");
        return;
    }
    say("selected " + lighting.entries()[*lights_.selected].name);
}

bool Session::obey_light(Command command) {
    LightEditor& lighting = show_->lighting();
    const std::size_t count = lighting.entries().size();
    const auto changed = [&](LightChange change) { change_ = std::max(change_, change); };
    if (command == Command::next_light) {
        if (count == 0) return true;
        lights_.selected = lights_.selected ? (*lights_.selected + 1) % count : 0;
        say("selected " + lighting.entries()[*lights_.selected].name);
        return true;
    }
    if (command == Command::undo_light || command == Command::redo_light) {
        const bool is_undo = command == Command::undo_light;
        if (is_undo ? lighting.undo() : lighting.redo())
            changed(LightChange::place);
        else
            say(is_undo ? "nothing to undo" : "nothing to do again");
        return true;
    }
    for (const auto& [grips, verb] : {std::pair(Command::move_light, Verb::move),
                                      {Command::turn_light, Verb::turn},
                                      {Command::scale_light, Verb::scale}})
        if (command == grips) {
            take_grip(verb);
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
        lighting.enable(lamp, !lighting.entries()[lamp].is_enabled);
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
