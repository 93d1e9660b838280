#pragma once
// Application of the viewer: the window, the loop, and the one place that applies what tools change.
#include "viewer/app/panels.hpp"
#include "viewer/document/watch.hpp"

#include <array>

namespace sr::viewer {

class App {
public:
    /// Opens the window and begins to load the scene. @throws Error
    explicit App(Options options);
    ~App();
    App(const App&) = delete;
    App& operator=(const App&) = delete;

    /// Runs until the window is closed or `stop` is requested. @throws Error if the first scene
    /// cannot be shown
    void run(const std::stop_token& stop);

    const Statistics& statistics() const { return workspace_.statistics; }

private:
    using Clock = std::chrono::steady_clock;

    void wait() const;
    void hand_on_typed();
    bool draws_again() const;
    Activity activity() const;
    void resize();
    Changes follow_shape();
    void log_picture() const;
    void report_keys();
    void follow_keys();
    Changes update(double seconds);
    Changes dispatch(const Event& event);
    Changes dispatch_to_tools(const Event& event);
    Changes open_first(const Event& event);
    Changes dispatch_key(const KeyEvent& key);
    Changes cancel_innermost();
    bool belongs_to_panel(const Event& event) const;
    Changes execute(Command command);
    void apply(Changes changes);
    void advance(double seconds);
    void present();
    void hand_over_seen(const ScreenRectangle& place);
    bool is_hidden() const;
    void update_title();
    void toggle_fullscreen();

    gl::Window window_;
    WindowInput input_;
    Ui ui_;
    std::string keys_problem_; // of the file of keys; empty once it is shown
    std::string refused_keys_; // what was said of the file of keys last; empty: nothing is wrong with it
    Watch keys_watch_;
    Workspace workspace_;
    Presenter presenter_;
    Panels panels_;
    Tools tools_; // in the order in which they get events and draw
    int frames_to_draw_ = 0;
    int frames_kept_ = 0; // since a key asked for a text field
    std::string title_;
    std::array<int, 4> windowed_{40, 40, 1280,
                                 720}; // place and size of the window before it became fullscreen
};

} // namespace sr::viewer
