#include "viewer/app.hpp"

#include "core/error.hpp"
#include "image/file.hpp"
#include "viewer/config.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <fmt/format.h>
#include <optional>
#include <utility>
#include <vector>

namespace sr::viewer {
namespace {

constexpr int frames_after_change = 3; // a panel knows its size only after it was drawn
constexpr double poll_interval = 0.2;  // [s] between two updates while nothing happens
constexpr double wait_interval = 0.01; // [s] likewise, while a tool waits for another thread

gl::WindowOptions window_options(const Options& options) {
    const WindowSize last = remembered_size();
    gl::WindowOptions window;
    window.title = "Steradian";
    window.width = options.size ? options.size->width : last.width > 0 ? last.width : 1280;
    window.height = options.size ? options.size->height : last.height > 0 ? last.height : 720;
    window.is_visible = true;
    window.is_fullscreen = options.is_fullscreen;
    window.debug = options.gl_debug;
    return window;
}

/// All tools, in the order in which they get events and draw. A drag of a light comes before a drag of the
/// view, a click on a light before a probe.
Tools make_tools(Workspace& workspace) {
    Tools tools;
    for (const auto make : {make_transform,      make_mix_lights,   make_look_at_pixels,
                            make_navigate,       make_place_camera, make_revisit_views,
                            make_show_grid,      make_show_times,   make_edit_lights,
                            make_inspect,        make_animate,      make_adjust_display,
                            make_compare,        make_assignment,   make_tick,
                            make_probe,          make_explain,      make_measure_illuminance,
                            make_view_light,     make_files,        make_turntable,
                            make_export_picture, make_copy_picture, make_keep_edits})
        if (auto tool = make(workspace)) tools.push_back(std::move(tool));
    return tools;
}

/// The keys in use; absent if the file of keys is wrong. `problem`: says what is wrong with it; empty if
/// nothing is.
std::optional<Keymap> read_keys(std::string& problem) {
    problem.clear();
    try {
        return Keymap::in_use();
    } catch (const Error& error) {
        problem = error.what();
        return std::nullopt;
    }
}

} // namespace

App::App(Options options)
    : window_(window_options(options)),
      input_(window_.handle()),
      ui_(window_.handle()),
      workspace_{.options = options,
                 .window = window_,
                 .input = input_,
                 .ui = ui_,
                 .keys = read_keys(keys_problem_).value_or(Keymap()),
                 .messages = Messages(options.is_verbose),
                 .exposure = Exposure(options.ev100)},
      panels_(workspace_),
      tools_(make_tools(workspace_)) {
    Statistics& statistics = workspace_.statistics;
    statistics.start.emplace_back("window", statistics.since_begin());
    statistics.renderer = window_.info().renderer;
    workspace_.display.curve = options.tone_curve;
    keys_watch_.set({keys_file()});
    input_.keep_after([this](const KeyEvent& key) {
        if (workspace_.question) return false;
        // A field takes no characters in the frame of a key with Ctrl. Enter in the palette may open a field.
        if (ui_.has_keyboard()) return (key.modifiers & control) || panels_.runs_command(key.key);
        const auto command = workspace_.keys.command_of(key.key, key.modifiers);
        return command && opens_text_field(*command);
    });
    resize();
    workspace_.has_first_page = options.scene.empty();
    if (workspace_.has_first_page)
        workspace_.messages.notify(
            workspace_.keys.hint("No scene is open. A list finds all commands", Command::find_command) + ".");
    else
        workspace_.open(options.scene);
    if (!keys_problem_.empty() && !options.is_verbose) write_remark(keys_problem_);
    if (workspace_.has_first_page) report_keys();
}

App::~App() {
    if (workspace_.options.is_fullscreen || glfwGetWindowMonitor(window_.handle())) return;
    const vec2 size = input_.window_size();
    remember_size({static_cast<int>(size.x), static_cast<int>(size.y)});
}

/// Shows once what is wrong with the file of keys. A scene that has been loaded ends the error of an earlier
/// one, so the first scene comes first.
void App::report_keys() {
    if (keys_problem_.empty()) return;
    refused_keys_ = std::exchange(keys_problem_, {});
    workspace_.messages.fail("Your keys are not used, but the built-in ones.", refused_keys_);
}

/// Takes the keys of a file of keys that has changed. One that is wrong leaves the keys as they are.
void App::follow_keys() {
    if (!keys_watch_.has_changed()) return;
    Messages& messages = workspace_.messages;
    const std::string before = refused_keys_;
    if (std::optional<Keymap> keys = read_keys(refused_keys_)) {
        workspace_.keys = *std::move(keys);
        if (messages.has_error() && messages.error_text() == before) messages.clear_error();
        std::error_code ignored;
        messages.notify(std::filesystem::exists(keys_file(), ignored)
                            ? fmt::format("The keys are those of {} now.", keys_file().string())
                            : "Your file of keys is gone: the built-in keys are in use.");
    } else {
        messages.fail("Your keys stay as they were.", refused_keys_);
    }
    apply(Change::redraw);
}

void App::run(const std::stop_token& stop) {
    auto last = Clock::now();
    Changes drawn; // by panels of the frame before
    while (!workspace_.is_closing && !stop.stop_requested()) {
        wait();
        const double seconds =
            std::chrono::duration<double>(Clock::now() - std::exchange(last, Clock::now())).count();
        if (is_hidden() && !input_.has_cancel()) continue; // all waits until it is seen again, or closed
        resize();
        apply(std::exchange(drawn, {}));
        if (const Changes loaded = workspace_.take_loaded(); loaded.any()) {
            apply(loaded);
            report_keys();
            if (loaded == everything) apply(follow_shape()); // the window may have changed while it loaded
        }
        follow_keys();
        apply(update(seconds));
        apply(std::exchange(workspace_.answered, {}));
        apply(panels_.update());
        hand_on_typed();
        std::vector<Event> events = input_.take();
        if (input_.take_damage() || !events.empty()) apply(Change::redraw);
        if (!draws_again()) continue;
        ui_.begin(taps_among(events)); // before the events, so that it knows which ones belong to panels
        for (; !events.empty(); events = input_.take()) { // tools send events, too
            Changes changes;
            for (const Event& event : events) {
                changes |= dispatch(event);
                workspace_.display.ev100 = workspace_.exposure.ev100(); // the next one may write what is seen
            }
            apply(changes);
        }
        auto begin = Clock::now();
        const auto end_part = [&](double FrameTimes::*part) {
            if (!workspace_.statistics.measures_frames) return;
            glFinish();
            const auto now = Clock::now();
            workspace_.statistics.last_frame.*part =
                std::chrono::duration<double>(now - std::exchange(begin, now)).count();
        };
        advance(seconds);
        end_part(&FrameTimes::sampling);
        present();
        end_part(&FrameTimes::display);
        drawn = panels_.draw(tools_);
        glBindFramebuffer(GL_FRAMEBUFFER, 0); // a panel may have read a film
        ui_.end();
        end_part(&FrameTimes::panels);
        glfwSwapBuffers(window_.handle());
        workspace_.statistics.presented(workspace_.scene != nullptr);
        --frames_to_draw_;
        update_title();
        if (ui_.needs_frame()) drawn |= Change::redraw;
        if (ui_.took_keyboard()) workspace_.messages.log("text field focused");
        if (ui_.changed_field()) workspace_.messages.log("keyboard in another field");
        if (!window_.debug_messages().empty()) window_.require_silence(); // asking OpenGL would wait for it
    }
}

/// Hands on what was typed once the text field that a key has asked for has the keyboard, or once none can
/// come any more: the command was refused.
void App::hand_on_typed() {
    constexpr int longest = 12; // frames that a field takes to appear and to get the keyboard
    if (!input_.is_keeping()) {
        frames_kept_ = 0;
        return;
    }
    if (++frames_kept_ == 1) return; // the key has not been handled yet
    if (!ui_.has_keyboard() && draws_again() && frames_kept_ < longest) return;
    const std::vector<TypedEvent> typed = input_.release();
    const bool runs_command =
        std::ranges::any_of(typed, [&](const TypedEvent& event) { return panels_.runs_command(event.key); });
    // The command may open a field; and if nothing is kept, the next key waits again.
    frames_kept_ = runs_command || !input_.is_keeping() ? 0 : longest;
    ui_.replay(typed);
    frames_to_draw_ = std::max(frames_to_draw_, frames_after_change);
}

Activity App::activity() const {
    if (!workspace_.scene) return workspace_.loading ? Activity::waiting : Activity::idle;
    Activity activity = Activity::idle;
    for (const auto& tool : tools_) activity = std::max(activity, tool->activity());
    return activity;
}

/// True if nobody can see the window: it is minimised.
bool App::is_hidden() const {
    return glfwGetWindowAttrib(window_.handle(), GLFW_ICONIFIED)
           || !glfwGetWindowAttrib(window_.handle(), GLFW_VISIBLE);
}

bool App::draws_again() const {
    return frames_to_draw_ > 0 || activity() >= Activity::active
           || (workspace_.scene && !workspace_.is_mixing && !workspace_.scene->render().is_converged());
}

/// Sleeps while there is nothing to do: neither processor nor GPU is used.
void App::wait() const {
    if (draws_again() && !is_hidden())
        glfwPollEvents();
    else
        glfwWaitEventsTimeout(activity() == Activity::waiting ? wait_interval : poll_interval);
}

/// Gives the film the room that panels leave.
void App::resize() {
    int width = 0, height = 0;
    glfwGetFramebufferSize(window_.handle(), &width, &height);
    if (width == 0 || height == 0) return; // it is minimised
    panels_.begin();
    const vec2 size = glm::round(workspace_.layout.film().size * vec2(width, height) / input_.window_size());
    if (size == vec2(workspace_.width, workspace_.height)) return;
    workspace_.width = static_cast<int>(size.x);
    workspace_.height = static_cast<int>(size.y);
    if (!workspace_.scene) return;
    workspace_.scene->resize(workspace_.width, workspace_.height);
    apply(follow_shape());
}

/// Tells the camera the shape of the film. A camera that frames the scene frames it in this shape.
Changes App::follow_shape() {
    CameraController& camera = *workspace_.camera;
    camera.set_aspect_ratio(workspace_.aspect_ratio());
    if (camera.argument() != "auto") return Change::redraw;
    camera.use({workspace_.scene->framing_camera(workspace_.aspect_ratio()), "auto"});
    return Change::camera;
}

/// Says that the picture has converged, and where it is: in one line, so that who reads it knows both at
/// once.
void App::log_picture() const {
    const Area at = workspace_.layout.film();
    workspace_.messages.log(fmt::format("converged: {}, {}x{} pixels at {},{}, --camera '{}'{}",
                                        progress_of(workspace_.scene->render()), workspace_.width,
                                        workspace_.height, at.from.x, at.from.y,
                                        workspace_.camera->argument(), workspace_.time_arguments()));
}

Changes App::update(double seconds) {
    Changes changes;
    if (!workspace_.scene) return changes;
    for (const auto& tool : tools_) changes |= tool->update(seconds);
    return changes;
}

/// True if a panel takes the event.
bool App::belongs_to_panel(const Event& event) const {
    if (!std::holds_alternative<ButtonEvent>(event) && !std::holds_alternative<ScrollEvent>(event))
        return false;
    const auto* button = std::get_if<ButtonEvent>(&event);
    if (workspace_.question) return !button || button->is_down; // a drag ends where its button is released
    return ui_.has_pointer()
           && std::ranges::none_of(tools_, [](const auto& tool) { return tool->holds_pointer(); });
}

/// A key goes to a question, or else to the tools. If none handles it, its command does.
Changes App::dispatch_key(const KeyEvent& key) {
    if (!key.is_down) return {};
    if (workspace_.question) {
        const Answer* const answer = workspace_.question->answer_of(key.key);
        if (answer && workspace_.question->is_shown) workspace_.answer(*answer);
        return Change::redraw;
    }
    if (panels_.take(key)) return Change::redraw;
    const bool has_dialog = panels_.holds_keyboard() || std::ranges::any_of(tools_, [](const auto& tool) {
                                return tool->holds_keyboard();
                            });
    for (const auto& tool : tools_)
        if (const auto changes = workspace_.scene && !has_dialog ? tool->handle(key) : std::nullopt)
            return *changes;
    const auto command = workspace_.keys.command_of(key.key, key.modifiers);
    if (command == Command::cancel && ui_.has_keyboard() && !has_dialog) return {}; // leaves the field
    const bool is_typed = (ui_.has_keyboard() || has_dialog) && command && !works_in_text_fields(*command);
    return command && !is_typed ? execute(*command) : Changes();
}

Changes App::dispatch(const Event& event) {
    if (std::holds_alternative<CloseEvent>(event)) workspace_.leave(Departure::quit);
    if (const auto* drop = std::get_if<DropEvent>(&event))
        for (const std::string& file : drop->files) input_.put(FileEvent{file});
    if (const auto* key = std::get_if<KeyEvent>(&event)) return dispatch_key(*key);
    if (const auto command = command_in(event)) return execute(*command); // of a menu
    const bool is_view =
        std::holds_alternative<ViewEvent>(event) || std::holds_alternative<LightViewEvent>(event);
    if (is_view && workspace_.refuses(Command::next_view)) return Change::redraw;
    return belongs_to_panel(event) ? Changes() : dispatch_to_tools(event);
}

/// Opens a scene from the first page.
Changes App::open_first(const Event& event) {
    if (command_in(event) && !workspace_.loading) workspace_.messages.notify("Open a scene first.");
    const auto* chosen = std::get_if<FileEvent>(&event);
    if (!chosen) return {};
    if (has_extension(chosen->file, scene_extensions))
        workspace_.open(chosen->file);
    else
        workspace_.messages.fail("Cannot open the file.",
                                 Error({chosen->file}, "is no scene", "give a .gltf or .glb file").what());
    return Change::redraw;
}

Changes App::dispatch_to_tools(const Event& event) {
    if (!workspace_.scene) return open_first(event);
    const bool is_for_all = std::holds_alternative<MotionEvent>(event);
    Changes changes;
    bool is_handled = false;
    for (const auto& tool : tools_) {
        const auto handled = tool->handle(event);
        if (handled) changes |= *handled;
        is_handled = is_handled || handled;
        if (is_handled && !is_for_all) break;
    }
    if (const auto* file = std::get_if<FileEvent>(&event); file && !is_handled)
        workspace_.messages.fail(
            "Cannot open the file.",
            Error({file->file}, "is neither a scene nor a picture",
                  "give a .gltf or .glb to open, an .exr, .hdr, .png or .jpg to compare with")
                .what());
    return changes;
}

Changes App::execute(Command command) {
    if (workspace_.refuses(command)) return Change::redraw;
    switch (command) {
    case Command::quit: workspace_.leave(Departure::quit); break;
    case Command::fullscreen: toggle_fullscreen(); break;
    case Command::cancel: return cancel_innermost();
    case Command::open_file:
    case Command::save_as: workspace_.show_panels(); [[fallthrough]]; // their dialog is a panel
    default:
        if (!panels_.execute(command)) return dispatch_to_tools(CommandEvent{command});
    }
    return Change::redraw;
}

/// Cancels one thing: the help, a dialog, an error, or what a tool has begun, the last tool first.
Changes App::cancel_innermost() {
    if (panels_.close_one()) return Change::redraw;
    const auto cancel = [this](bool is_dialog) {
        std::optional<Changes> changes;
        for (auto tool = tools_.rbegin(); tool != tools_.rend() && !changes; ++tool)
            if (workspace_.scene && (!is_dialog || (*tool)->holds_keyboard()))
                changes = (*tool)->handle(CommandEvent{Command::cancel});
        return changes;
    };
    if (const auto closed = cancel(true)) return *closed;
    if (workspace_.messages.has_error()) {
        workspace_.messages.clear_error();
        return Change::redraw;
    }
    return cancel(false).value_or(Changes());
}

/// Brings changes into the picture, and tells the tools.
void App::apply(Changes changes) {
    if (!changes.any()) return;
    frames_to_draw_ = frames_after_change;
    if (!workspace_.scene) return;
    if (!(changes == Change::redraw) && !(changes == Change::display)) workspace_.depth.restart();
    const bool is_new = changes == everything; // a new scene view has all of it already
    const bool are_relit = changes.has(Change::lights) || changes.has(Change::shadows);
    if (!is_new && are_relit && workspace_.is_mixing && !changes.has(Change::shadows))
        workspace_.scene->stage_lights(); // the mixer shows it
    else if (!is_new && are_relit)
        workspace_.relight(changes.has(Change::shadows));
    workspace_.selected.keep_below(workspace_.scene->lights().entries().size());
    if (!is_new && changes.has(Change::camera)) workspace_.scene->move(workspace_.camera->camera());
    for (const auto& tool : tools_) tool->notice(changes);
}

/// Adds samples, and follows with the exposure.
void App::advance(double seconds) {
    if (!workspace_.scene) return;
    ProgressiveRender& render = workspace_.scene->render();
    workspace_.statistics.frame(render, seconds);
    const bool was_converged = render.is_converged();
    if (activity() != Activity::exclusive && !workspace_.is_mixing) render.advance();
    if (render.is_converged() && !was_converged) log_picture();
    workspace_.exposure.measure(render, workspace_.statistics.drawn_frames);
    if (workspace_.exposure.advance(std::min(seconds, 0.1))) frames_to_draw_ = std::max(frames_to_draw_, 2);
}

void App::present() {
    int width = 0, height = 0;
    glfwGetFramebufferSize(window_.handle(), &width, &height);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDisable(GL_SCISSOR_TEST);
    glClearColor(0.1f, 0.1f, 0.1f, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT);
    if (!workspace_.scene || workspace_.scene->render().sample_count() == 0) return;
    FilmSum film, reference;
    for (const auto& tool : tools_) {
        if (!film.sum) film = tool->film();
        if (!reference.sum) reference = tool->reference_film();
    }
    if (!film.sum) film = workspace_.scene->render().shown();
    workspace_.display.ev100 = workspace_.exposure.ev100();
    const Area area = workspace_.shown_area();
    const vec2 dense = vec2(width, height) / input_.window_size();
    const vec2 from = glm::round(dense * area.from), size = glm::round(dense * area.size);
    const ScreenRectangle place{static_cast<int>(from.x), height - static_cast<int>(from.y + size.y),
                                static_cast<int>(size.x), static_cast<int>(size.y)};
    presenter_.draw(film, reference, workspace_.display, place);
    if (workspace_.takes_seen) hand_over_seen(place);
}

/// Hands over the picture in the frame, before panels are drawn over it.
void App::hand_over_seen(const ScreenRectangle& place) {
    const auto take = std::exchange(workspace_.takes_seen, {});
    image::Image picture(place.width, place.height, 3);
    std::vector<std::uint8_t> codes(picture.pixels.size());
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(place.x, place.y, place.width, place.height, GL_RGB, GL_UNSIGNED_BYTE, codes.data());
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    const std::size_t row = 3 * static_cast<std::size_t>(picture.width);
    for (std::size_t i = 0; i < codes.size(); ++i) // GL's first row is the lowest
        picture.pixels[codes.size() - row - i / row * row + i % row] = static_cast<float>(codes[i]) / 255.0f;
    try {
        take(picture);
    } catch (const Error& error) {
        workspace_.messages.fail("The picture is not written or copied.", error.what());
    }
}

/// The title has the progress, which the task bar shows.
void App::update_title() {
    std::string title = "Steradian";
    if (workspace_.scene) {
        const ProgressiveRender& render = workspace_.scene->render();
        const std::string file = std::filesystem::path(workspace_.scene->loaded().file).filename().string();
        title = render.is_converged() ? fmt::format("{} - {} - Steradian", file, progress_of(render))
                                      : fmt::format("{} - Steradian", file);
        if (workspace_.scene->lights().is_unsaved()) title = "*" + title;
    }
    if (title == title_) return;
    title_ = title;
    glfwSetWindowTitle(window_.handle(), title.c_str());
}

void App::toggle_fullscreen() {
    GLFWwindow* window = window_.handle();
    GLFWmonitor* monitor = glfwGetPrimaryMonitor();
    if (!monitor) return;
    auto& [x, y, width, height] = windowed_;
    if (glfwGetWindowMonitor(window)) {
        glfwSetWindowMonitor(window, nullptr, x, y, width, height, GLFW_DONT_CARE);
        return;
    }
    glfwGetWindowPos(window, &x, &y);
    glfwGetWindowSize(window, &width, &height);
    const GLFWvidmode* mode = glfwGetVideoMode(monitor);
    glfwSetWindowMonitor(window, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
}

} // namespace sr::viewer
