#pragma once
// Dear ImGui on a window, for as long as this lives.
#include "viewer/input.hpp"

#include <string>
#include <vector>

namespace sr::viewer {

class Ui {
public:
    /// Remembers where panels are in $XDG_CONFIG_HOME/steradian/panels.ini (or ~/.config).
    explicit Ui(GLFWwindow* window);
    ~Ui();
    Ui(const Ui&) = delete;
    Ui& operator=(const Ui&) = delete;

    /// Between the two, panels are described. `taps`: the keys that were pressed and released since the last
    /// frame, which Dear ImGui before 1.87 would not see.
    void begin(std::vector<KeyEvent> taps);
    void end();

    /// Whether the pointer is on a panel, and whether a text field has the keyboard.
    bool has_pointer() const;
    bool has_keyboard() const;
    /// ImGuiWindowFlags of a panel. Tab goes from one field to the next, but into the first by a click or
    /// Enter: until then it is the next light's key.
    int panel_flags() const;
    bool has_active_item() const;          // a field or a button is in use
    bool has_queued_input() const;         // some input waits for the next frame
    float scale() const { return scale_; } // of a HiDPI screen

private:
    void watch_scale();

    GLFWwindow* window_;
    std::vector<KeyEvent> taps_;
    float scale_ = 0.0f;
    std::string layout_file_;
};

} // namespace sr::viewer
