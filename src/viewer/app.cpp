#include "viewer/app.hpp"

#include "core/error.hpp"
#include "core/math.hpp"
#include "image/file.hpp"
#include "viewer/config.hpp"
#include "viewer/panels/help.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <fmt/format.h>
#include <imgui.h>
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
std::vector<std::unique_ptr<Tool>> make_tools(Workspace& workspace) {
    std::vector<std::unique_ptr<Tool>> tools;
    for (const auto make :
         {make_transform, make_navigate, make_edit_lights, make_animate, make_adjust_display, make_compare,
          make_assignment, make_tick, make_probe, make_files, make_turntable, make_keep_edits})
        if (auto tool = make(workspace)) tools.push_back(std::move(tool));
    return tools;
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
                 .messages = Messages(options.is_verbose),
                 .exposure = Exposure(options.ev100)},
      tools_(make_tools(workspace_)) {
    Statistics& statistics = workspace_.statistics;
    statistics.start.emplace_back("window", statistics.since_begin());
    statistics.renderer = window_.info().renderer;
    workspace_.display.curve = options.tone_curve;
    glfwGetFramebufferSize(window_.handle(), &workspace_.width, &workspace_.height);
    workspace_.open(options.scene);
}

App::~App() {
    if (workspace_.options.is_fullscreen || glfwGetWindowMonitor(window_.handle())) return;
    const vec2 size = input_.window_size();
    remember_size({static_cast<int>(size.x), static_cast<int>(size.y)});
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
        apply(std::exchange(drawn, {}) | workspace_.take_loaded());
        apply(update(seconds));
        apply(std::exchange(workspace_.answered, {}));
        std::vector<Event> events = input_.take();
        if (input_.take_damage() || !events.empty()) apply(Change::redraw);
        if (!draws_again()) continue;
        ui_.begin(taps_among(events)); // before the events, so that it knows which ones belong to panels
        for (; !events.empty(); events = input_.take()) { // tools send events, too
            Changes changes;
            for (const Event& event : events) changes |= dispatch(event);
            apply(changes);
        }
        advance(seconds);
        present();
        drawn = draw_panels();
        ui_.end();
        glfwSwapBuffers(window_.handle());
        workspace_.statistics.presented(workspace_.scene != nullptr);
        --frames_to_draw_;
        update_title();
        if (ui_.needs_frame()) drawn |= Change::redraw;
        if (ui_.took_keyboard()) workspace_.messages.log("text field focused");
        window_.require_silence();
    }
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
           || (workspace_.scene && !workspace_.scene->render().is_converged());
}

/// Sleeps while there is nothing to do: neither processor nor GPU is used.
void App::wait() const {
    if (draws_again() && !is_hidden())
        glfwPollEvents();
    else
        glfwWaitEventsTimeout(activity() == Activity::waiting ? wait_interval : poll_interval);
}

void App::resize() {
    int width = 0, height = 0;
    glfwGetFramebufferSize(window_.handle(), &width, &height);
    const bool is_minimised = width == 0 || height == 0;
    if (is_minimised || (width == workspace_.width && height == workspace_.height)) return;
    workspace_.width = width;
    workspace_.height = height;
    if (workspace_.camera) workspace_.camera->set_aspect_ratio(workspace_.aspect_ratio());
    if (workspace_.scene) workspace_.scene->resize(width, height);
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
        if (const Answer* answer = workspace_.question->answer_of(key.key)) workspace_.answer(*answer);
        return Change::redraw;
    }
    const bool has_dialog =
        std::ranges::any_of(tools_, [](const auto& tool) { return tool->holds_keyboard(); });
    for (const auto& tool : tools_)
        if (const auto changes = workspace_.scene && !has_dialog ? tool->handle(key) : std::nullopt)
            return *changes;
    const auto command = command_of(key.key, key.modifiers);
    if (command == Command::cancel && ui_.has_keyboard() && !has_dialog) return {}; // leaves the field
    const bool is_typed = (ui_.has_keyboard() || has_dialog) && command && !works_in_text_fields(*command);
    return command && !is_typed ? execute(*command) : Changes();
}

Changes App::dispatch(const Event& event) {
    if (std::holds_alternative<CloseEvent>(event)) workspace_.leave(Departure::quit);
    if (const auto* drop = std::get_if<DropEvent>(&event))
        for (const std::string& file : drop->files) input_.put(FileEvent{file});
    if (const auto* key = std::get_if<KeyEvent>(&event)) return dispatch_key(*key);
    return belongs_to_panel(event) ? Changes() : dispatch_to_tools(event);
}

Changes App::dispatch_to_tools(const Event& event) {
    if (!workspace_.scene) return {};
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
    switch (command) {
    case Command::help: has_help_ = !has_help_; break;
    case Command::panels: has_panels_ = !has_panels_; break;
    case Command::messages: has_history_ = !has_history_; break;
    case Command::quit: workspace_.leave(Departure::quit); break;
    case Command::fullscreen: toggle_fullscreen(); break;
    case Command::cancel: return cancel_innermost();
    case Command::open_file:
    case Command::save_as: has_panels_ = true; [[fallthrough]]; // their dialog is a panel
    default: return dispatch_to_tools(CommandEvent{command});
    }
    return Change::redraw;
}

/// Cancels one thing: the help, a dialog, an error, or what a tool has begun, the last tool first.
Changes App::cancel_innermost() {
    if (std::exchange(has_help_, false) || std::exchange(has_history_, false)) return Change::redraw;
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
    const bool is_new = changes == everything; // a new scene view has all of it already
    if (!is_new && (changes.has(Change::lights) || changes.has(Change::shadows)))
        workspace_.scene->relight(changes.has(Change::shadows));
    if (!is_new && changes.has(Change::camera)) workspace_.scene->move(workspace_.camera->camera());
    for (const auto& tool : tools_) tool->notice(changes);
}

/// Adds samples, and follows with the exposure.
void App::advance(double seconds) {
    if (!workspace_.scene) return;
    ProgressiveRender& render = workspace_.scene->render();
    workspace_.statistics.frame(render, seconds);
    const bool was_converged = render.is_converged();
    if (activity() != Activity::exclusive) render.advance();
    if (render.is_converged() && !was_converged)
        workspace_.messages.log(fmt::format("converged: {}, --camera '{}'{}", progress_of(render),
                                            workspace_.camera->argument(), workspace_.time_arguments()));
    workspace_.exposure.measure(render, workspace_.statistics.drawn_frames);
    if (workspace_.exposure.advance(std::min(seconds, 0.1))) frames_to_draw_ = std::max(frames_to_draw_, 2);
}

void App::present() {
    if (!workspace_.scene || workspace_.scene->render().sample_count() == 0) {
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        glClearColor(0.1f, 0.1f, 0.1f, 1.0f);
        glClear(GL_COLOR_BUFFER_BIT);
        return;
    }
    FilmSum reference;
    for (const auto& tool : tools_)
        if (!reference.sum) reference = tool->reference_film();
    workspace_.display.ev100 = workspace_.exposure.ev100();
    presenter_.draw(workspace_.scene->render().shown(), reference, workspace_.display, workspace_.width,
                    workspace_.height);
    if (!workspace_.seen_file.empty()) write_seen();
}

/// Writes the frame as a PNG, before panels are drawn over it.
void App::write_seen() {
    const std::string file = std::exchange(workspace_.seen_file, {});
    image::Image picture(workspace_.width, workspace_.height, 3);
    std::vector<std::uint8_t> codes(picture.pixels.size());
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, picture.width, picture.height, GL_RGB, GL_UNSIGNED_BYTE, codes.data());
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    const std::size_t row = 3 * static_cast<std::size_t>(picture.width);
    for (std::size_t i = 0; i < codes.size(); ++i) // GL's first row is the lowest
        picture.pixels[codes.size() - row - i / row * row + i % row] = static_cast<float>(codes[i]) / 255.0f;
    try {
        image::write(picture, file, image::SampleType::integer8);
        workspace_.messages.notify(fmt::format("Wrote {}.", file));
    } catch (const Error& error) {
        workspace_.messages.fail("Cannot write the picture.", error.what());
    }
}

Changes App::draw_panels() {
    help_panel(has_help_);
    const Messages& messages = workspace_.messages;
    if (messages.has_error()) error_panel(messages.error_title(), messages.error_text());
    if (workspace_.question)
        if (const Answer* answer = draw_question(*workspace_.question)) workspace_.answer(*answer);
    if (!workspace_.scene) {
        message_area({fmt::format("loading {} ...", workspace_.options.scene), {}, {}});
        return {};
    }
    history_panel(has_history_, messages.history());
    if (!has_panels_) return {};
    Changes changes;
    const Overlay overlay{workspace_.projection(), ui_.scale()};
    for (const auto& tool : tools_) changes |= tool->draw(overlay);
    message_area({progress_of(workspace_.scene->render()), under_pointer(), messages.status()});
    return changes | draw_main_panel();
}

Changes App::draw_main_panel() {
    Changes changes;
    ImGui::SetNextWindowPos({10.0f, 10.0f}, ImGuiCond_FirstUseEver);
    ImGui::SetNextWindowSizeConstraints({0.0f, 0.0f}, {1e4f, 0.92f * workspace_.window_size().y});
    if (ImGui::Begin("Steradian", nullptr, ui_.panel_flags())) {
        ImGui::PushItemWidth(170.0f * ui_.scale());
        ImGui::PushTextWrapPos(280.0f * ui_.scale());
        for (const auto& tool : tools_) changes |= tool->draw_section();
        ImGui::TextDisabled("F1 or ? shows all keys");
        ImGui::PopTextWrapPos();
        ImGui::PopItemWidth();
    }
    keep_in_viewport();
    ImGui::End();
    return changes;
}

/// Radiance and luminance at the pixel under the pointer.
std::string App::under_pointer() const {
    const vec2 place = input_.pointer() / workspace_.window_size();
    const ProgressiveRender& render = workspace_.scene->render();
    if (render.is_interactive() || render.sample_count() == 0 || ui_.has_pointer()) return {};
    if (!(place.x >= 0.0f && place.x < 1.0f && place.y >= 0.0f && place.y < 1.0f)) return {};
    const int column = static_cast<int>(place.x * static_cast<float>(workspace_.width));
    const int row = static_cast<int>(place.y * static_cast<float>(workspace_.height));
    const output::Variable* const view = workspace_.display.view;
    if (view && view->finish != output::Finish::luminance) return {}; // the film has no radiance
    const vec3 L = render.pixel(place);
    return fmt::format("{},{}: L {:.4g} {:.4g} {:.4g}, luminance {:.4g} {}", column, row, L.r, L.g, L.b,
                       luminance(L), scene::radiance_unit(workspace_.scene->stage().scene.units));
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
