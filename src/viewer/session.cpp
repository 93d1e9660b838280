#include "viewer/session.hpp"

#include "core/error.hpp"
#include "core/output.hpp"
#include "gltf/named_files.hpp"
#include "core/luminance.hpp"
#include "viewer/animation_bar.hpp"
#include "viewer/config.hpp"
#include "viewer/panels.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <bit>
#include <filesystem>
#include <fmt/format.h>
#include <imgui.h>

namespace sr::viewer {
namespace {

constexpr int frames_after_event = 3; // panels settle by then: they learn their size by being drawn
constexpr double poll_interval = 0.2; // [s] between two looks at files and signals while nothing happens

gl::WindowOptions window_options(const Options& options) {
    const WindowSize last = remembered_size();
    gl::WindowOptions window;
    window.title = "Steradian";
    window.width = options.width > 0 ? options.width : last.width > 0 ? last.width : 1280;
    window.height = options.height > 0 ? options.height : last.height > 0 ? last.height : 720;
    window.is_visible = true;
    window.is_fullscreen = options.is_fullscreen;
    window.debug = options.gl_debug;
    return window;
}

} // namespace

Session::Session(Options options)
    : options_(std::move(options)),
      window_(window_options(options_)),
      input_(window_.handle()),
      ui_(window_.handle()),
      hand_(options_.has_inertia),
      exposure_(options_.ev100) {
    statistics_.start.emplace_back("window", statistics_.since_begin());
    statistics_.renderer = window_.info().renderer;
    look_.curve = options_.tone_curve;
    glfwGetFramebufferSize(window_.handle(), &width_, &height_);
    if (!options_.submission.empty()) {
        marks_ = std::make_unique<Marks>(options_.submission, options_.program);
        marks_->begin();
        options_.shows_reference = true;
    }
    open(options_.scene);
}

Session::~Session() {
    if (options_.is_fullscreen || glfwGetWindowMonitor(window_.handle())) return;
    const vec2 size = window_size();
    remember_size({static_cast<int>(size.x), static_cast<int>(size.y)});
}

vec2 Session::window_size() const {
    int width = 1, height = 1;
    glfwGetWindowSize(window_.handle(), &width, &height);
    return {static_cast<float>(std::max(1, width)), static_cast<float>(std::max(1, height))};
}

void Session::run(const std::function<bool()>& is_interrupted) {
    while (!is_closing_ && !is_interrupted()) {
        wait();
        take_loaded();
        take_flip();
        take_marks();
        watch_files();
        std::vector<Event> events = input_.take();
        if (input_.take_damage() || !events.empty()) frames_to_draw_ = frames_after_event;
        if (lights_.wants_focus() || dialog_.wants_focus()) frames_to_draw_ = std::max(frames_to_draw_, 1);
        if (!is_busy()) continue;
        ui_.begin(taps_among(events)); // before the events, so that it knows whose the pointer is
        for (const Event& event : events) handle(event);
        advance();
        draw();
        note_keyboard();
        if (question_) answer_question();
        window_.require_silence();
    }
}

/// Whether a frame is to be drawn.
bool Session::is_busy() const {
    return frames_to_draw_ > 0 || hand_.is_flying() || hand_.is_gliding() || playback_.is_playing
           || (show_ && !show_->picture().is_done())
           || (shows_reference_beside() && !(show_->reference() && show_->reference()->is_done()));
}

/// Sleeps while there is nothing to do: no processor and no GPU is used.
void Session::wait() {
    if (is_busy())
        glfwPollEvents();
    else
        glfwWaitEventsTimeout(loading_ || flipping_ || (marks_ && marks_->is_checking()) ? 0.01
                                                                                         : poll_interval);
}

void Session::take_loaded() {
    if (!loading_ || loading_->wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
    frames_to_draw_ = frames_after_event;
    try {
        auto loading = std::exchange(loading_, std::nullopt);
        show(loading->get());
        error_text_.clear();
    } catch (const Error& error) {
        if (!show_) throw;
        fail("The file cannot be shown; this is the one before.", error.what());
    }
}

void Session::show(LoadedScene scene) {
    const bool is_same_file = show_ && show_->scene().file == scene.file;
    const float aspect = static_cast<float>(width_) / static_cast<float>(height_);
    Eye eye(named_camera(scene.stage, options_.camera), scene.bounds, aspect, scene.stage.scene.origin);
    if (is_same_file && scene::is_look_at(eye_->argument())) { // a free camera stays where it is
        eye = *eye_;
        eye.set_origin(scene.stage.scene.origin);
        eye.set_bounds(scene.bounds);
    }
    if (!show_) {
        statistics_.start.emplace_back("load (beside the window)", scene.seconds);
        statistics_.start.emplace_back("until loaded", statistics_.since_begin());
    }
    auto shown = std::make_unique<Show>(std::move(scene), options_, eye.camera(), width_, height_);
    const bool is_first = !show_;
    const bool keeps_edits = std::exchange(keeps_edits_, false) && is_same_file;
    if (keeps_edits) shown->take_edits(show_->lighting());
    show_ = std::move(shown);
    eye_ = std::move(eye);
    begin_playback(is_same_file);
    if (!is_same_file)
        exposure_.forget();
    else
        say(!keeps_edits               ? "scene read anew"
            : options_.variant.empty() ? "no variant"
                                       : "variant " + options_.variant);
    measured_samples_ = 0;
    if (is_first) {
        statistics_.start.emplace_back("upload", show_->upload_seconds());
        statistics_.start.emplace_back("compile", show_->compile_seconds());
    }
    for (const std::string& remark : show_->scene().remarks) {
        say(remark);
        write_remark(remark);
    }
    std::vector<std::filesystem::path> files = gltf::named_files(show_->scene().file);
    files.emplace_back(show_->scene().file);
    scene_watch_.set(std::move(files));
    if (is_first) shader_watch_.set({options_.shaders.begin(), options_.shaders.end()});
    lights_.selected.reset();
    grip_.reset();
    probe_.answer.reset();
    remember_file(show_->scene().file);
}

/// Brings everything up to now: size, flight, samples, exposure.
void Session::advance() {
    const auto now = Clock::now();
    const double seconds = std::chrono::duration<double>(now - last_frame_).count();
    last_frame_ = now;
    int width = 0, height = 0;
    glfwGetFramebufferSize(window_.handle(), &width, &height);
    const bool is_minimised = width == 0 || height == 0;
    if (!is_minimised && (width != width_ || height != height_)) {
        width_ = width;
        height_ = height;
        if (eye_) eye_->set_aspect_ratio(static_cast<float>(width) / static_cast<float>(height));
        if (show_) show_->resize(width, height);
    }
    if (!show_) return;
    fly(seconds);
    relight();
    play(seconds);
    Picture& picture = show_->picture();
    if (was_moving_ && picture.is_moving()) {
        statistics_.moving_frames.push_back(seconds);
        statistics_.moving_samples.push_back(picture.seconds_per_sample());
        statistics_.moving_scales.push_back(picture.scale());
        statistics_.moving_cpu.push_back(Statistics::cpu() - last_cpu_);
    }
    was_moving_ = picture.is_moving();
    last_cpu_ = Statistics::cpu();
    const bool was_done = picture.is_done();
    picture.advance();
    advance_reference();
    if (picture.is_done() && !was_done && options_.is_verbose)
        print_remark("converged: {}, --camera '{}'{}", progress_of(picture), eye_->argument(),
                     moment_argument());
    measure_exposure();
    advance_turntable();
    if (exposure_.advance(std::min(seconds, 0.1))) frames_to_draw_ = std::max(frames_to_draw_, 1);
}

/// Reading the film back costs: every eighth moving frame, and a standing picture's sample number 1, 2, 4, …
/// and last.
void Session::measure_exposure() {
    const Picture& picture = show_->picture();
    const int samples = picture.sample_count();
    if (!exposure_.is_automatic() || samples == 0) return;
    const bool is_due = picture.is_moving()
                            ? statistics_.drawn_frames % 8 == 0
                            : std::has_single_bit(static_cast<unsigned>(samples)) || picture.is_done();
    if (!is_due || (!picture.is_moving() && samples == measured_samples_)) return;
    measured_samples_ = picture.is_moving() ? 0 : samples;
    exposure_.measured(image::auto_ev100(picture.film()));
}

void Session::draw() {
    if (show_ && show_->picture().sample_count() > 0) {
        look_.ev100 = exposure_.ev100();
        const Picture& picture = show_->picture();
        screen_.draw(picture.shown(), other_film(), look_, width_, height_);
    } else {
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        glClearColor(0.1f, 0.1f, 0.1f, 1.0f);
        glClear(GL_COLOR_BUFFER_BIT);
    }
    draw_panels();
    ui_.end();
    glfwSwapBuffers(window_.handle());
    ++statistics_.drawn_frames;
    if (show_ && statistics_.start.size() == 5) {
        statistics_.start.emplace_back("first picture", statistics_.since_begin());
        statistics_.start.emplace_back("first picture, processor time", Statistics::cpu());
    }
    --frames_to_draw_;
    update_title();
}

void Session::draw_panels() {
    help_panel(has_help_);
    if (!error_text_.empty()) error_panel(error_title_, error_text_);
    if (!show_) {
        Status status;
        status.message = fmt::format("loading {} ...", options_.scene);
        status_line(status);
        return;
    }
    if (!has_panels_) return;
    draw_dialog();
    probe_.draw_directions(show_->scene().stage, projection(), ui_.scale());
    probe_.draw(show_->scene().stage, show_->lighting(), lights_.selected, ui_.scale());
    lights_.draw_marks(show_->lighting(), projection(), ui_.scale());
    draw_animation();
    draw_grip();
    draw_marks();
    const Picture& picture = show_->picture();
    status_line({progress_of(picture), under_pointer(), message_});
    ImGui::SetNextWindowPos({10.0f, 10.0f}, ImGuiCond_FirstUseEver);
    ImGui::SetNextWindowSizeConstraints({0.0f, 0.0f}, {1e4f, 0.92f * window_size().y});
    if (ImGui::Begin("Steradian", nullptr, ui_.panel_flags())) {
        ImGui::PushItemWidth(170.0f * ui_.scale());
        ImGui::PushTextWrapPos(280.0f * ui_.scale());
        const scene::Scene& scene = show_->scene().stage.scene;
        const CameraWish wish = camera_panel(*eye_, scene.cameras);
        if (wish.command) obey(*wish.command);
        if (wish.file_camera) eye_->take(named_camera(scene.cameras, *wish.file_camera));
        if (wish.moved) eye_->move_to(*wish.moved);
        if (wish.file_camera || wish.moved) move_camera();
        draw_lights();
        if (const auto variant = variants_panel(show_->scene().contents.variants, show_->scene().variant))
            choose_variant(*variant);
        picture_panel(exposure_, look_, scene::radiance_unit(scene.units));
        obey(compare_panel(look_, reference_ ? &*reference_ : nullptr, flip_result_,
                           options_.rendering.estimator, options_.visibility));
        ImGui::TextDisabled("F1 or ? shows all keys");
        ImGui::PopTextWrapPos();
        ImGui::PopItemWidth();
    }
    ImGui::End();
}

/// Radiance and luminance where the pointer is.
std::string Session::under_pointer() const {
    const vec2 place = place_of(input_.pointer());
    const Picture& picture = show_->picture();
    if (picture.is_moving() || picture.sample_count() == 0 || ui_.has_pointer()) return {};
    if (!(place.x >= 0.0f && place.x < 1.0f && place.y >= 0.0f && place.y < 1.0f)) return {};
    const int column = static_cast<int>(place.x * static_cast<float>(width_));
    const int row = static_cast<int>(place.y * static_cast<float>(height_));
    const vec3 L = picture.pixel(place);
    return fmt::format("{},{}: L {:.4g} {:.4g} {:.4g}, luminance {:.4g} {}", column, row, L.r, L.g, L.b,
                       luminance(L), scene::radiance_unit(show_->scene().stage.scene.units));
}

/// The title says how far the picture is, for those who look at the task bar.
void Session::update_title() {
    std::string title = "Steradian";
    if (show_) {
        const Picture& picture = show_->picture();
        const std::string file = std::filesystem::path(show_->scene().file).filename().string();
        title = picture.is_done() ? fmt::format("{} - {} - Steradian", file, progress_of(picture))
                                  : fmt::format("{} - Steradian", file);
    }
    if (title == title_) return;
    title_ = title;
    glfwSetWindowTitle(window_.handle(), title.c_str());
}

} // namespace sr::viewer
