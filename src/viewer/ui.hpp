#pragma once
// Dear ImGui on a window, during the lifetime of a Ui.
#include "viewer/app/fonts.hpp"
#include "viewer/app/layout.hpp"
#include "viewer/input.hpp"

#include <span>
#include <string>
#include <utility>
#include <vector>

namespace sr::viewer {

/// Request for the keyboard by a text field. A new panel takes a frame or two to appear, so the request is
/// repeated until the field has the keyboard, or for as many frames as that can take (the panel may be
/// collapsed).
class FocusRequest {
public:
    void begin() { frames_left_ = 10; }
    bool is_pending() const { return frames_left_ > 0; }
    /// Reports, once a frame, whether the field has the keyboard.
    void update(bool has_keyboard) { frames_left_ = has_keyboard ? 0 : frames_left_ - 1; }

private:
    int frames_left_ = 0;
};

/// Places the next window of Dear ImGui over an area.
void place_next_window(const Area& area);

/// Moves the current ImGui window back into the viewport, between its Begin() and End().
void keep_in_viewport();

/// Explains the last item while the pointer is over it.
void tooltip(const std::string& text);

/// Writes a line on a dark ground over the picture, its upper left corner at `at`.
void draw_caption(vec2 at, const std::string& text);

/// Names the columns of the table that has begun, each with what it means as a tooltip.
void draw_table_heads(std::span<const std::pair<std::string, const char*>> heads);

class Ui;
/// Puts a line in the larger font into the current window.
void heading(const char* text, const Ui& ui);

class Ui {
public:
    /// Saves the places of panels to $XDG_CONFIG_HOME/steradian/panels.ini (or ~/.config).
    explicit Ui(GLFWwindow* window);
    ~Ui();
    Ui(const Ui&) = delete;
    Ui& operator=(const Ui&) = delete;

    /// Hands on what was typed before a text field had the keyboard.
    void replay(const std::vector<TypedEvent>& typed);

    /// Panels are described between begin() and end(). `taps`: the keys that were pressed and released since
    /// the last frame, which Dear ImGui before 1.87 would miss.
    void begin(std::vector<KeyEvent> taps);
    void end();

    /// True if the pointer is on a panel; if a text field has the keyboard.
    bool has_pointer() const;
    bool has_keyboard() const;
    /// ImGuiWindowFlags of a panel. Tab selects the next light until a field has the keyboard; then it goes
    /// to the next field.
    int panel_flags(bool is_docked) const;
    /// True if panels need another frame: an item became active or inactive, or input is queued.
    bool needs_frame();
    /// True once after a text field took the keyboard.
    bool took_keyboard();
    /// True once after another text field than the last one took it.
    bool changed_field();
    float scale() const { return scale_; } // of a HiDPI screen
    const Fonts& fonts() const { return fonts_; }

private:
    void watch_scale();

    GLFWwindow* window_;
    std::vector<KeyEvent> taps_;
    float scale_ = 0.0f;
    Fonts fonts_;
    bool had_active_item_ = false;
    bool had_keyboard_ = false;
    unsigned field_ = 0; // that had the keyboard last; Dear ImGui's number
    std::string layout_file_;
};

} // namespace sr::viewer
