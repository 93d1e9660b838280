#pragma once
// One run of the viewer, from opening the window to closing it.
#include "gl/window.hpp"
#include "viewer/compare_panel.hpp"
#include "viewer/exposure.hpp"
#include "viewer/file_dialog.hpp"
#include "viewer/hand.hpp"
#include "viewer/handles.hpp"
#include "viewer/input.hpp"
#include "viewer/lights_panel.hpp"
#include "viewer/marks.hpp"
#include "viewer/playback.hpp"
#include "viewer/probe_panel.hpp"
#include "viewer/screen.hpp"
#include "viewer/show.hpp"
#include "viewer/statistics.hpp"
#include "viewer/ui.hpp"
#include "viewer/watch.hpp"

#include <array>
#include <functional>
#include <future>

namespace sr::viewer {

/// A turn around the pivot that is being written, a PNG a step.
struct Turntable {
    static constexpr int steps = 36;

    std::string folder;
    int step = 0;
};

class Session {
public:
    /// Opens the window and begins to load. @throws Error
    explicit Session(Options options);
    ~Session();

    /// Until the window is closed, or `is_interrupted` says so. @throws Error if the first scene cannot be
    /// shown
    void run(const std::function<bool()>& is_interrupted);

    const Statistics& statistics() const { return statistics_; }

private:
    using Clock = std::chrono::steady_clock;

    // session.cpp: the loop
    bool is_busy() const;
    void wait();
    void take_loaded();
    void show(LoadedScene scene);
    void advance();
    void draw();
    void draw_panels();
    void update_title();
    void measure_exposure();
    std::string under_pointer() const;
    vec2 window_size() const;
    vec2 place_of(vec2 at) const { return at / window_size(); }

    // session_input.cpp: what a person wants
    void handle(const Event& event);
    void handle_key(const KeyEvent& event);
    void handle_pointer(const Event& event);
    void fly(double seconds);
    void obey(Command command);
    bool obey_picture(Command command);
    bool obey_program(Command command);
    void move_camera();
    void copy_view();
    void paste_view();
    void toggle_fullscreen();
    void say(std::string message);
    void note_keyboard();

    // session_lights.cpp: editing lights
    Projection projection() const;
    void click(vec2 at);
    bool obey_light(Command command);
    scene::Bounds selection() const;
    void draw_lights();
    void relight();

    // session_grip.cpp: the light in the hand
    bool handle_grip(const Event& event);
    bool handle_grip(const KeyEvent& event);
    void take_grip(Verb verb);
    void take_grip(Verb verb, std::optional<int> axis, bool is_free);
    void pull_grip(vec2 pointer);
    void let_go(bool keeps);
    LightChange change_of_grip() const;
    void draw_grip() const;
    vec3 grip_center() const;
    std::optional<Handles> handles() const;

    // session_animation.cpp: what moves by itself, and variants
    void begin_playback(bool is_same_file);
    void play(double elapsed);
    void show_moment();
    std::optional<Command> key_of_the_bar(const KeyEvent& event) const;
    bool obey_animation(Command command);
    void draw_animation();
    void choose_variant(const std::string& name);
    void next_variant();
    std::string moment_argument() const;

    // session_compare.cpp: questions to the picture
    void answer_question();
    std::optional<Lobe> lobe_of(const render::PixelTerms& terms, const render::RenderOptions& options,
                                int column, int row) const;
    void obey(const CompareWish& wish);
    void change_estimator(render::Estimator estimator);
    void change_visibility(render::Visibility visibility);
    void keep_picture();
    void begin_flip();
    void take_flip();
    void load_reference(const std::string& file);
    void next_comparison();
    FilmSum other_film() const;

    // session_assignment.cpp: a student's folder
    void take_marks();
    bool shows_reference_beside() const;
    void advance_reference();
    void draw_marks();

    // session_files.cpp: what is read and written
    void open(const std::string& file);
    void take_dropped(const std::vector<std::string>& files);
    void reload();
    void read_again();
    void watch_files();
    void reload_shaders();
    void write_png();
    void write_exr();
    void begin_turntable();
    void advance_turntable();
    void draw_dialog();
    void save_scene(const std::string& file);
    void fail(const std::string& title, const std::string& text);

    Options options_;
    Statistics statistics_;
    gl::Window window_;
    Input input_;
    Ui ui_;
    Screen screen_;
    std::optional<std::future<LoadedScene>> loading_;
    std::unique_ptr<Show> show_;
    std::optional<Eye> eye_;
    Hand hand_;
    LightsPanel lights_;
    LightChange change_ = LightChange::none; // of the lights, since the last frame
    std::optional<Grip> grip_;               // on the selected light
    vec2 pointer_{0.0f};                     // where it was when the event at hand happened
    Playback playback_;
    bool bar_has_pointer_ = false;
    bool keeps_edits_ = false; // of lights, when the file that is being read is there
    ProbePanel probe_;
    std::optional<vec2> question_; // the place in the window that is to be asked
    std::unique_ptr<Marks> marks_; // of a student's folder; null: none
    std::optional<Reference> reference_;
    std::optional<Reference> flip_;
    std::optional<std::future<FlipMap>> flipping_;
    std::string flip_result_;
    FileDialog dialog_;
    std::optional<Turntable> turntable_;
    Watch scene_watch_;
    Watch shader_watch_;
    Exposure exposure_;
    Look look_;
    std::string message_;
    std::string error_title_;
    std::string error_text_; // empty: none
    std::string title_;
    int width_ = 0; // of the framebuffer [pixels]
    int height_ = 0;
    int frames_to_draw_ = 0;
    bool has_panels_ = true;
    bool has_help_ = false;
    bool is_closing_ = false;
    Clock::time_point last_frame_ = Clock::now();
    bool was_moving_ = false;
    bool had_keyboard_ = false; // a field, at the last frame
    bool had_active_item_ = false;
    double last_cpu_ = 0.0;                          // processor time at the last frame [s]
    std::size_t camera_index_ = 0;                   // of the file's, which C goes on from
    std::array<int, 4> windowed_{40, 40, 1280, 720}; // where the window was before it filled the screen
    int measured_samples_ = 0;                       // at which the exposure was last measured
};

} // namespace sr::viewer
