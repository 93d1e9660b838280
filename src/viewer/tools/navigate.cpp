#include "viewer/tools/navigate.hpp"
#include "viewer/fields.hpp"

#include "core/error.hpp"
#include "settings/options.hpp"
#include "viewer/config.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <imgui.h>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace sr::viewer {
namespace {

constexpr float click_slack = 4.0f;   // [pixels] of motion that still make a click
constexpr float turn_per_height = pi; // [rad] of a drag over the height of the window
constexpr float notch = 0.9f;         // factor of the distance for a notch of the wheel
constexpr float pan_per_notch = 0.05f;
constexpr float memory = 0.03f;          // [s] over which the velocity of a drag is measured
constexpr float glide_half_life = 0.12f; // [s]
constexpr float min_glide = 0.01f;       // [heights of the window / s]
constexpr float max_elapsed = 0.2f;      // [s] of a glide or a flight: a longer frame does not throw the view

constexpr float flight_speed = 0.25f; // [radii of the scene / s]
constexpr float fast = 4.0f;          // with Shift

bool is_of_pointer(const Event& event) {
    return std::holds_alternative<MotionEvent>(event) || std::holds_alternative<ScrollEvent>(event)
           || std::holds_alternative<ButtonEvent>(event);
}

} // namespace

Navigation::Drag Navigation::drag_of(const ButtonEvent& press) {
    if (press.modifiers & alt) // Maya
        return press.button == Button::left     ? Drag::orbit
               : press.button == Button::middle ? Drag::pan
                                                : Drag::dolly;
    if (press.button == Button::right) return Drag::look;
    if (press.modifiers & shift) return Drag::pan; // Blender
    if (press.modifiers & control) return Drag::dolly;
    return Drag::orbit;
}

void Navigation::press(const ButtonEvent& event) {
    drag_ = drag_of(event);
    button_ = event.button;
    modifiers_ = event.modifiers;
    pressed_at_ = at_;
    is_click_ = event.button == Button::left && !(event.modifiers & alt);
    gliding_ = Drag::none;
    travelled_ = velocity_ = vec2(0.0f);
}

void Navigation::drag(Drag how, vec2 by, Viewpoint& view) {
    switch (how) {
    case Drag::orbit: return orbit(view, turn_per_height * by);
    case Drag::look: return look_around(view, 0.5f * turn_per_height * by);
    case Drag::pan: return pan(view, by);
    case Drag::dolly: return dolly(view, std::exp2(3.0f * by.y));
    case Drag::none: return;
    }
}

Navigation::Effect Navigation::move(vec2 to, Viewpoint& view, vec2 window) {
    const vec2 by = (to - at_) / window.y;
    at_ = to;
    if (drag_ == Drag::none) return {};
    if (is_click_ && glm::distance(to, pressed_at_) <= click_slack) return {};
    is_click_ = false;
    drag(drag_, by, view);
    travelled_ += by;
    return {true, {}};
}

bool Navigation::advance(double seconds, Viewpoint& view) {
    const auto elapsed = static_cast<float>(seconds);
    if (is_dragging() && elapsed > 0.0f) {
        velocity_ = glm::mix(travelled_ / elapsed, velocity_, std::exp2(-elapsed / memory));
        travelled_ = vec2(0.0f);
    }
    if (!is_gliding()) return false;
    velocity_ *= std::exp2(-elapsed / glide_half_life);
    if (glm::length(velocity_) < min_glide) {
        gliding_ = Drag::none;
        return false;
    }
    drag(gliding_, std::min(elapsed, max_elapsed) * velocity_, view);
    return true;
}

Navigation::Effect Navigation::scroll(const ScrollEvent& event, Viewpoint& view,
                                      const std::optional<vec3>& target) {
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

Navigation::Effect Navigation::handle(const Event& event, Viewpoint& view, vec2 window,
                                      const PointUnder& point_under) {
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
    return is_click_ ? Effect{false, at_, modifiers_} : Effect{};
}

void fly(Viewpoint& view, vec3 direction, float metres) {
    if (direction != vec3(0.0f)) walk(view, metres * glm::normalize(direction));
}

std::optional<Changes> Navigate::handle(const Event& event) {
    if (const auto command = command_in(event)) return execute(*command);
    if (const auto* key = std::get_if<KeyEvent>(&event)) {
        const bool flies = navigation_.is_flying() && !(key->modifiers & control); // W A S D Q E, by update()
        return flies ? std::optional(Changes()) : std::nullopt;
    }
    if (!is_of_pointer(event)) return std::nullopt;
    const auto point_under = [this](vec2 at) -> std::optional<vec3> {
        const auto hit = first_hit(ws_.scene->stage().scene, ws_.projection().ray(at));
        return hit ? std::optional(hit->point) : std::nullopt;
    };
    Viewpoint view = ws_.camera->view();
    const Navigation::Effect effect = navigation_.handle(event, view, ws_.picture().size, point_under);
    if (effect.clicked) ws_.input.put(ClickEvent{*effect.clicked, effect.modifiers});
    if (!effect.has_moved) return effect.clicked ? Changes(Change::redraw) : Changes();
    ws_.camera->move_to(view);
    return Change::camera;
}

Changes Navigate::update(double seconds) {
    Viewpoint view = ws_.camera->view();
    bool has_moved = navigation_.advance(seconds, view);
    if (navigation_.is_flying()) {
        const auto axis = [this](int plus, int minus) {
            return static_cast<float>(ws_.input.is_down(plus)) - static_cast<float>(ws_.input.is_down(minus));
        };
        const vec3 direction(axis(GLFW_KEY_D, GLFW_KEY_A), axis(GLFW_KEY_E, GLFW_KEY_Q),
                             axis(GLFW_KEY_S, GLFW_KEY_W));
        const float radius = ws_.camera->bounds().is_empty() ? 1.0f : ws_.camera->bounds().radius();
        const bool is_fast =
            ws_.input.is_down(GLFW_KEY_LEFT_SHIFT) || ws_.input.is_down(GLFW_KEY_RIGHT_SHIFT);
        const float time = std::min(static_cast<float>(seconds), max_elapsed);
        fly(view, direction, time * radius * flight_speed * (is_fast ? fast : 1.0f));
        has_moved = has_moved || direction != vec3(0.0f);
    }
    if (!has_moved) return {};
    ws_.camera->move_to(view);
    return Change::camera;
}

std::optional<Changes> Navigate::execute(Command command) {
    switch (command) {
    case Command::copy_view: return copy_view();
    case Command::paste_view: return paste_view();
    case Command::file_camera:
        ws_.camera->use(named_camera(ws_.scene->stage(), ws_.options.camera));
        return Change::camera;
    case Command::next_camera: return next_camera();
    default:
        if (!ws_.camera->execute(command, selection())) return std::nullopt;
        return Change::camera;
    }
}

Changes Navigate::next_camera() {
    const auto& cameras = ws_.scene->stage().scene.cameras;
    if (cameras.empty()) return {};
    camera_index_ = (camera_index_ + 1) % cameras.size();
    ws_.camera->use(named_camera(cameras, camera_index_));
    ws_.messages.notify("Camera " + cameras[camera_index_].name + ".");
    return Change::camera;
}

/// Copies the arguments of `steradian render` that make this picture.
/// What is seen and no argument of `render` says, with what to do; empty if there is nothing.
std::string Navigate::left_out() const {
    std::vector<std::string> parts;
    if (ws_.scene->lights().is_unsaved())
        parts.push_back(ws_.keys.hint("unsaved edits: save them first", Command::save_as));
    if (!ws_.scene->loaded().hidden.empty()) parts.emplace_back("hidden objects");
    if (ws_.scene->alone()) parts.emplace_back("that one light is alone");
    if (ws_.is_term_left_out) parts.emplace_back("the term that is left out");
    if (ws_.shown_picture()) parts.emplace_back("the kept picture");
    const bool has_softboxes =
        std::ranges::any_of(ws_.scene->lights().entries(),
                            [](const LightEntry& entry) { return entry.kind == LightEdit::Kind::softbox; });
    if (has_softboxes) parts.emplace_back("softboxes, which render places for this camera");
    return parts.empty() ? "" : fmt::format(" Not in it: {}.", fmt::join(parts, "; "));
}

/// Copies the command that makes the picture which is seen. Edits that were saved are in their file.
Changes Navigate::copy_view() {
    settings::RenderSettings seen = ws_.seen_settings();
    if (!ws_.written.empty() && !ws_.scene->lights().is_unsaved()) {
        seen.scene = ws_.written.back().file;
        seen.camera = ws_.camera->look_at_text(); // numbers of cameras may be others in it
    }
    // A view has no error of its own: it has as many samples as are seen.
    if (seen.view && seen.stop.asks_for_error()) seen.stop = {ws_.scene->render().sample_count(), {}, {}};
    const std::string text = fmt::format("steradian render {} -o {}{}", settings::shell_word(seen.scene),
                                         settings::shell_word(free_name(ws_.scene->loaded().file, ".png")),
                                         settings::render_arguments(seen));
    ws_.input.set_clipboard(text);
    ws_.messages.notify(fmt::format("Copied: {}{}", text, left_out()));
    return Change::redraw;
}

/// Takes the view from the clipboard: a look-at description, alone or in a command that was copied.
Changes Navigate::paste_view() {
    constexpr std::string_view flag = "--camera ";
    std::string text = ws_.input.clipboard();
    if (const auto at = text.find(flag); at != std::string::npos) text.erase(0, at + flag.size());
    if (const auto quote = text.find('\''); quote != std::string::npos)
        text = text.substr(quote + 1, text.find('\'', quote + 1) - quote - 1);
    try {
        ws_.camera->go_to(text);
        return Change::camera;
    } catch (const Error& error) {
        ws_.messages.notify(error.what());
        return Change::redraw;
    }
}

/// The bounds of the selected lights or object; empty if none is selected.
scene::Bounds Navigate::selection() const {
    scene::Bounds bounds;
    if (!ws_.selected && ws_.object) return bounds_of(ws_.scene->stage().scene, *ws_.object);
    if (!ws_.selected) return bounds;
    const scene::Bounds& all = ws_.camera->bounds();
    const float min_size = all.is_empty() ? 0.1f : 0.02f * all.radius();
    for (const std::size_t entry : ws_.selected.entries())
        for (const scene::Light& light : ws_.scene->lights().lights_of(entry)) {
            const scene::Bounds one = bounds_of(light, min_size);
            if (one.is_empty()) continue;
            bounds.extend(one.min);
            bounds.extend(one.max);
        }
    return bounds;
}

Changes Navigate::draw_section() {
    const bool is_unfolded = ImGui::CollapsingHeader("Camera", ImGuiTreeNodeFlags_DefaultOpen);
    tooltip("cameras of the file, and the view");
    if (!is_unfolded) return {};
    Changes changes;
    CameraController& camera = *ws_.camera;
    const auto& cameras = ws_.scene->stage().scene.cameras;
    for (std::size_t i = 0; i < cameras.size(); ++i) {
        const std::string name = fmt::format("{} {}##camera{}", i, cameras[i].name, i);
        if (!ImGui::Selectable(name.c_str())) continue;
        camera.use(named_camera(cameras, i));
        changes |= Change::camera;
    }
    Viewpoint view = camera.view();
    float degrees = glm::degrees(view.yfov);
    if (number_field("field of view", degrees, {1.0f, 150.0f, "%.1f deg"})) {
        view.yfov = glm::radians(degrees);
        camera.move_to(view);
        changes |= Change::camera;
    }
    tooltip("the full vertical field of view [degrees]; a click with Ctrl types it");
    bool is_first = true;
    for (const auto& [label, command] : {std::pair("frame all", Command::frame_all),
                                         {"level", Command::level},
                                         {"copy", Command::copy_view},
                                         {"paste", Command::paste_view}}) {
        if (!std::exchange(is_first, false)) ImGui::SameLine();
        if (ImGui::Button(label)) changes |= execute(command).value_or(Changes());
        tooltip(ws_.keys.hint(info_of(command).what, command));
    }
    ImGui::TextDisabled("--camera %s", camera.argument().c_str());
    return changes;
}

std::unique_ptr<Tool> make_navigate(Workspace& workspace) { return std::make_unique<Navigate>(workspace); }

} // namespace sr::viewer
