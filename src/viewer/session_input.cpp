// What a person wants of the session: keys, pointer, files.
#include "viewer/session.hpp"

#include "core/error.hpp"
#include "core/output.hpp"
#include "viewer/pick.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <utility>

namespace sr::viewer {
namespace {

constexpr float stop = 1.0f / 3.0f;        // [EV] a key's press
constexpr float scenes_per_second = 0.25f; // how fast one flies, in radii of the scene
constexpr float faster = 4.0f;             // with Shift

/// Whether a key that means this is no text, so that a field that is being typed into leaves it alone.
bool is_nothing_to_type(Command command) {
    switch (command) {
    case Command::quit:
    case Command::open_file:
    case Command::save_as:
    case Command::reload:
    case Command::fullscreen: return true;
    default: return false;
    }
}

} // namespace

void Session::handle(const Event& event) {
    if (std::holds_alternative<CloseEvent>(event))
        is_closing_ = true;
    else if (const auto* drop = std::get_if<DropEvent>(&event))
        take_dropped(drop->files);
    else if (const auto* key = std::get_if<KeyEvent>(&event))
        handle_key(*key);
    else
        handle_pointer(event);
}

void Session::handle_key(const KeyEvent& event) {
    if (!event.is_down) return;
    if (handle_grip(event)) return;
    const auto meant = command_of(event.key, event.modifiers);
    if (ui_.has_keyboard() && event.key != GLFW_KEY_ESCAPE && !(meant && is_nothing_to_type(*meant))) return;
    if (hand_.is_flying() && !(event.modifiers & control)) return; // W A S D Q E fly, and nothing else
    if (const auto command = key_of_the_bar(event))
        obey(*command);
    else if (meant)
        obey(*meant);
}

void Session::handle_pointer(const Event& event) {
    if (!eye_) return;
    const bool is_held = hand_.is_dragging() || grip_;
    if (ui_.has_pointer() && !is_held && !std::holds_alternative<MotionEvent>(event)) return;
    Viewpoint view = eye_->view();
    if (show_ && handle_grip(event)) {
        if (std::holds_alternative<MotionEvent>(event)) // it keeps track of the pointer
            hand_.take(event, view, window_size(), [](vec2) { return std::nullopt; });
        return;
    }
    const auto point_under = [this](vec2 at) -> std::optional<vec3> {
        const Ray ray = ray_through(eye_->camera(), eye_->aspect_ratio(), place_of(at));
        const auto hit = first_hit(show_->scene().stage.scene, ray);
        return hit ? std::optional(hit->point) : std::nullopt;
    };
    const Hand::Effect effect = hand_.take(event, view, window_size(), point_under);
    if (effect.has_moved) {
        eye_->move_to(view);
        move_camera();
    }
    if (effect.clicked) click(*effect.clicked);
}

void Session::fly(double seconds) {
    if (Viewpoint gliding = eye_->view(); hand_.advance(seconds, gliding)) {
        eye_->move_to(gliding);
        move_camera();
    }
    if (!hand_.is_flying()) return;
    const auto axis = [this](int plus, int minus) {
        return static_cast<float>(input_.is_down(plus)) - static_cast<float>(input_.is_down(minus));
    };
    const vec3 toward(axis(GLFW_KEY_D, GLFW_KEY_A), axis(GLFW_KEY_E, GLFW_KEY_Q),
                      axis(GLFW_KEY_S, GLFW_KEY_W));
    if (toward == vec3(0.0f)) return;
    const float radius = eye_->bounds().is_empty() ? 1.0f : eye_->bounds().radius();
    const bool is_fast = input_.is_down(GLFW_KEY_LEFT_SHIFT) || input_.is_down(GLFW_KEY_RIGHT_SHIFT);
    Viewpoint view = eye_->view();
    viewer::fly(view, toward,
                static_cast<float>(std::min(seconds, 0.2)) * radius * scenes_per_second
                    * (is_fast ? faster : 1.0f));
    eye_->move_to(view);
    move_camera();
}

void Session::move_camera() {
    show_->move(eye_->camera());
    measured_samples_ = 0;
}

void Session::obey(Command command) {
    if (obey_program(command) || !show_) return;
    if (obey_picture(command) || obey_light(command) || obey_animation(command)) return;
    if (eye_->obey(command, selection())) move_camera();
}

bool Session::obey_program(Command command) {
    switch (command) {
    case Command::help: has_help_ = !has_help_; return true;
    case Command::panels: has_panels_ = !has_panels_; return true;
    case Command::quit: is_closing_ = true; return true;
    case Command::fullscreen: toggle_fullscreen(); return true;
    case Command::reload: reload(); return true;
    case Command::open_file: dialog_.show(FileDialog::Purpose::open, options_.scene); return true;
    case Command::cancel:
        has_help_ = false;
        error_text_.clear();
        lights_.selected.reset();
        probe_.answer.reset();
        dialog_.close();
        turntable_.reset();
        look_.comparison = Comparison::none;
        return true;
    default: return false;
    }
}

bool Session::obey_picture(Command command) {
    const auto& cameras = show_->scene().stage.scene.cameras;
    switch (command) {
    case Command::darker: exposure_.fix(exposure_.ev100() + stop); return true;
    case Command::brighter: exposure_.fix(exposure_.ev100() - stop); return true;
    case Command::auto_exposure: exposure_.make_automatic(); return true;
    case Command::next_tone_curve:
        look_.curve = static_cast<image::ToneCurve>((static_cast<int>(look_.curve) + 1) % 4);
        return true;
    case Command::false_color: look_.is_false_color = !look_.is_false_color; return true;
    case Command::copy_view: copy_view(); return true;
    case Command::paste_view: paste_view(); return true;
    case Command::screenshot_png: write_png(); return true;
    case Command::screenshot_exr: write_exr(); return true;
    case Command::save_as: dialog_.show(FileDialog::Purpose::save, show_->scene().file); return true;
    case Command::turntable: begin_turntable(); return true;
    case Command::compare: next_comparison(); return true;
    case Command::ask: question_ = input_.pointer(); return true;
    case Command::file_camera:
        eye_->take(named_camera(show_->scene().stage, options_.camera));
        move_camera();
        return true;
    case Command::next_camera:
        if (cameras.empty()) return true;
        camera_index_ = (camera_index_ + 1) % cameras.size();
        eye_->take(named_camera(cameras, camera_index_));
        say("camera " + cameras[camera_index_].name);
        move_camera();
        return true;
    default: return false;
    }
}

/// What is copied makes this very picture in a terminal: the same camera, the same pixels.
void Session::copy_view() {
    const render::StopRule& stop = options_.stop;
    std::string text = fmt::format("--camera '{}' --size {}x{} --samples {}", eye_->argument(), width_,
                                   height_, stop.samples);
    if (stop.error) text += fmt::format(" --error {}%", static_cast<float>(100.0 * *stop.error));
    text += moment_argument();
    glfwSetClipboardString(window_.handle(), text.c_str());
    say("copied: " + text);
}

void Session::paste_view() {
    const char* copied = glfwGetClipboardString(window_.handle());
    std::string text = copied ? copied : "";
    // Out of the command line that copy_view() makes, or by itself.
    if (const auto quote = text.find('\''); quote != std::string::npos)
        text = text.substr(quote + 1, text.find('\'', quote + 1) - quote - 1);
    try {
        const scene::LookAt view = scene::parsed_look_at(text, eye_->origin());
        eye_->take({scene::camera_at(view, eye_->bounds(), eye_->aspect_ratio()), scene::text_of(view)});
        move_camera();
    } catch (const Error& error) {
        say(error.what());
    }
}

void Session::toggle_fullscreen() {
    GLFWwindow* window = window_.handle();
    GLFWmonitor* monitor = glfwGetPrimaryMonitor();
    if (!monitor) return;
    const GLFWvidmode* mode = glfwGetVideoMode(monitor);
    if (glfwGetWindowMonitor(window)) {
        glfwSetWindowMonitor(window, nullptr, windowed_[0], windowed_[1], windowed_[2], windowed_[3],
                             GLFW_DONT_CARE);
        return;
    }
    glfwGetWindowPos(window, &windowed_[0], &windowed_[1]);
    glfwGetWindowSize(window, &windowed_[2], &windowed_[3]);
    glfwSetWindowMonitor(window, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
}

/// Draws on while panels have something to hear or to tell. Says, to whoever drives the viewer by a program,
/// that a field takes what is typed from now on.
void Session::note_keyboard() {
    const bool has_active_item = ui_.has_active_item();
    const bool has_changed = std::exchange(had_active_item_, has_active_item) != has_active_item;
    if (has_changed || ui_.has_queued_input()) // the keyboard follows a frame later
        frames_to_draw_ = std::max(frames_to_draw_, 1);
    const bool has_keyboard = ui_.has_keyboard();
    if (!std::exchange(had_keyboard_, has_keyboard) && has_keyboard && options_.is_verbose)
        write_remark("a field has the keyboard");
}

void Session::say(std::string message) {
    message_ = std::move(message);
    if (options_.is_verbose) write_remark(message_);
}

} // namespace sr::viewer
