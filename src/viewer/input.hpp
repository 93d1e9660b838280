#pragma once
// What a person did since the last frame, in the order in which it happened.
#include "core/math.hpp"
#include "viewer/bindings.hpp"

#include <string>
#include <variant>
#include <vector>

struct GLFWwindow;

namespace sr::viewer {

enum class Button { left, right, middle };

struct KeyEvent {
    int key = 0;
    int modifiers = no_modifier;
    bool is_down = false; // pressed or repeated
};
struct ButtonEvent {
    Button button{};
    int modifiers = no_modifier;
    bool is_down = false;
};
struct MotionEvent {
    vec2 to{0.0f}; // in the window, from its upper left [pixels of the screen's coordinates]
};
struct ScrollEvent {
    vec2 by{0.0f}; // in notches; a trackpad sends parts of one
    int modifiers = no_modifier;
};
struct DropEvent {
    std::vector<std::string> files;
};
struct CloseEvent {};

using Event = std::variant<KeyEvent, ButtonEvent, MotionEvent, ScrollEvent, DropEvent, CloseEvent>;

/// The keys that were pressed and released since the last frame.
std::vector<KeyEvent> taps_among(const std::vector<Event>& events);

/// Collects the events of a window. It takes the window's user pointer and callbacks, so it comes before
/// whoever else wants to be called (Dear ImGui chains).
class Input {
public:
    explicit Input(GLFWwindow* window);
    ~Input();
    Input(const Input&) = delete;
    Input& operator=(const Input&) = delete;

    /// What came since the last call.
    std::vector<Event> take();
    /// Whether the window's contents must be drawn anew: it was resized or uncovered.
    bool take_damage();

    /// Whether Esc or closing the window waits to be taken: for work that looks up in between.
    bool wants_to_stop() const;

    bool is_down(int key) const;
    vec2 pointer() const;

    void put(Event event) { events_.push_back(std::move(event)); }
    void damage() { is_damaged_ = true; }

private:
    GLFWwindow* window_;
    std::vector<Event> events_;
    bool is_damaged_ = true;
};

} // namespace sr::viewer
