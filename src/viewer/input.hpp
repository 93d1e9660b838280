#pragma once
// Events of the window, in order, and events that tools send.
#include "core/math.hpp"
#include "viewer/bindings.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

struct GLFWwindow;

namespace sr::output {
struct Variable;
}

namespace sr::viewer {

enum class Button { left, right, middle };

struct KeyEvent {
    int key = 0; // by its label, as GLFW numbers the keys of a US keyboard
    int modifiers = no_modifier;
    bool is_down = false; // pressed or repeated
    int place = 0;        // the key of a US keyboard in the same place
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
struct CommandEvent { // a key's or a button's
    Command command{};
};
struct ViewEvent {                          // of a menu
    const output::Variable* view = nullptr; // null: radiance
};
struct LightViewEvent {               // of a menu
    std::optional<std::size_t> entry; // that lights the picture alone; absent: all do
};
struct ClickEvent { // the left button, pressed and released in one place
    vec2 at{0.0f};
    int modifiers = no_modifier; // Ctrl and Shift
};
struct FileEvent { // a file to open or to compare with
    std::string file;
};

using Event = std::variant<KeyEvent, ButtonEvent, MotionEvent, ScrollEvent, DropEvent, CloseEvent,
                           CommandEvent, ViewEvent, LightViewEvent, ClickEvent, FileEvent>;

/// The key whose label on a US keyboard is that of the key in this place. Letters and punctuation go by their
/// labels in the current layout; digits and all other keys go by their places. Needs GLFW.
int labelled(int place);

/// Keys that were pressed and released within `events`.
std::vector<KeyEvent> taps_among(const std::vector<Event>& events);

/// A key or a character as GLFW reports it.
struct TypedEvent {
    unsigned character = 0; // 0: a key
    int key = 0, scancode = 0, action = 0, modifiers = 0;
};

/// Collects the events of a window. It takes the user pointer and the callbacks of the window, so it must
/// be made before other users of callbacks (Dear ImGui chains).
class WindowInput {
public:
    explicit WindowInput(GLFWwindow* window);
    ~WindowInput();
    WindowInput(const WindowInput&) = delete;
    WindowInput& operator=(const WindowInput&) = delete;

    /// The input that has taken the user pointer of a window.
    static WindowInput& of(GLFWwindow* window);

    /// Keeps what is typed after such a key: the text field that the key asks for takes the keyboard some
    /// frames later.
    void keep_after(std::function<bool(const KeyEvent&)> asks_for_field) {
        asks_for_field_ = std::move(asks_for_field);
    }
    /// @return true if the event is kept, and goes nowhere now
    bool keep(const TypedEvent& event);
    bool is_keeping() const { return is_keeping_; }
    /// Returns what was kept, up to a key without a character (Enter, an arrow, one with Ctrl): a field takes
    /// the characters of a frame before its keys. Nothing more is kept once all is returned.
    std::vector<TypedEvent> release();

    /// Takes the events since the last call.
    std::vector<Event> take();
    /// Tells, once, that the window must be redrawn because it was resized or uncovered.
    bool take_damage();

    /// True if Esc or closing the window is among the events to take: cancels long work.
    bool has_cancel() const;

    bool is_down(int place) const; // by place, not by label
    vec2 pointer() const;
    vec2 window_size() const; // in the unit of the pointer
    std::string clipboard() const;
    void set_clipboard(const std::string& text);

    template<class AnyEvent>
    void put(AnyEvent event) {
        events_.emplace_back(std::move(event));
    }
    void damage() { is_damaged_ = true; }

private:
    GLFWwindow* window_;
    std::vector<Event> events_;
    bool is_damaged_ = true;
    std::function<bool(const KeyEvent&)> asks_for_field_;
    bool is_keeping_ = false;
    bool is_own_character_ = false; // the next event may be the character of the key that asks for a field
    std::vector<TypedEvent> kept_;
};

} // namespace sr::viewer
