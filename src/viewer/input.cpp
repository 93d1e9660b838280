#include "viewer/input.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace sr::viewer {
namespace {

WindowInput& input_of(GLFWwindow* window) { return WindowInput::of(window); }

int modifiers_of(int mods) {
    // ⌘ is what Ctrl is elsewhere.
    return ((mods & GLFW_MOD_SHIFT) ? shift : 0)
           | ((mods & (GLFW_MOD_CONTROL | GLFW_MOD_SUPER)) ? control : 0) | ((mods & GLFW_MOD_ALT) ? alt : 0);
}

void on_key(GLFWwindow* window, int key, int, int action, int mods) {
    input_of(window).put(KeyEvent{labelled(key), modifiers_of(mods), action != GLFW_RELEASE, key});
}

void on_button(GLFWwindow* window, int button, int action, int mods) {
    if (button > GLFW_MOUSE_BUTTON_MIDDLE) return;
    input_of(window).put(ButtonEvent{static_cast<Button>(button), modifiers_of(mods), action == GLFW_PRESS});
}

void on_motion(GLFWwindow* window, double x, double y) { input_of(window).put(MotionEvent{vec2(x, y)}); }

void on_scroll(GLFWwindow* window, double x, double y) {
    int mods = 0;
    for (const auto& [key, bit] : {std::pair(GLFW_KEY_LEFT_SHIFT, shift),
                                   {GLFW_KEY_RIGHT_SHIFT, shift},
                                   {GLFW_KEY_LEFT_CONTROL, control},
                                   {GLFW_KEY_RIGHT_CONTROL, control}})
        if (glfwGetKey(window, key) == GLFW_PRESS) mods |= bit;
    input_of(window).put(ScrollEvent{vec2(x, y), mods});
}

void on_drop(GLFWwindow* window, int count, const char** paths) {
    input_of(window).put(DropEvent{{paths, paths + count}});
}

} // namespace

int labelled(int place) {
    const bool is_printable = place > GLFW_KEY_SPACE && place <= GLFW_KEY_WORLD_2;
    const bool is_digit = place >= GLFW_KEY_0 && place <= GLFW_KEY_9; // their labels need Shift on AZERTY
    const char* const label = is_printable && !is_digit ? glfwGetKeyName(place, 0) : nullptr;
    if (!label || !label[0] || label[1]) return place;
    const char sign = label[0];
    if (sign >= 'a' && sign <= 'z') return GLFW_KEY_A + (sign - 'a');
    constexpr std::string_view punctuation = ",-./=[]"; // GLFW numbers them as ASCII does
    return punctuation.find(sign) == std::string_view::npos ? place : sign;
}

std::vector<KeyEvent> taps_among(const std::vector<Event>& events) {
    std::vector<KeyEvent> down, taps;
    for (const Event& event : events) {
        const auto* key = std::get_if<KeyEvent>(&event);
        if (!key) continue;
        const auto same = [&](const KeyEvent& other) { return other.place == key->place; };
        const auto pressed = std::ranges::find_if(down, same);
        if (key->is_down)
            down.push_back(*key);
        else if (pressed != down.end())
            taps.push_back(*pressed); // with the modifiers that it was pressed with
    }
    return taps;
}

WindowInput::WindowInput(GLFWwindow* window) : window_(window) {
    static_assert(static_cast<int>(Button::middle) == GLFW_MOUSE_BUTTON_MIDDLE);
    glfwSetWindowUserPointer(window, this);
    glfwSetKeyCallback(window, on_key);
    glfwSetMouseButtonCallback(window, on_button);
    glfwSetCursorPosCallback(window, on_motion);
    glfwSetScrollCallback(window, on_scroll);
    glfwSetDropCallback(window, on_drop);
    glfwSetWindowCloseCallback(window, [](GLFWwindow* w) { input_of(w).put(CloseEvent{}); });
    glfwSetWindowRefreshCallback(window, [](GLFWwindow* w) { input_of(w).damage(); });
    glfwSetFramebufferSizeCallback(window, [](GLFWwindow* w, int, int) { input_of(w).damage(); });
}

WindowInput::~WindowInput() {
    glfwSetKeyCallback(window_, nullptr);
    glfwSetMouseButtonCallback(window_, nullptr);
    glfwSetCursorPosCallback(window_, nullptr);
    glfwSetScrollCallback(window_, nullptr);
    glfwSetDropCallback(window_, nullptr);
    glfwSetWindowCloseCallback(window_, nullptr);
    glfwSetWindowRefreshCallback(window_, nullptr);
    glfwSetFramebufferSizeCallback(window_, nullptr);
}

WindowInput& WindowInput::of(GLFWwindow* window) {
    return *static_cast<WindowInput*>(glfwGetWindowUserPointer(window));
}

bool WindowInput::keep(const TypedEvent& event) {
    // A key that went on at once does not look held.
    if (is_keeping_ && event.character == 0 && event.action == GLFW_RELEASE
        && std::ranges::none_of(kept_, [&](const TypedEvent& kept) { return kept.key == event.key; }))
        return false;
    const bool is_own = std::exchange(is_own_character_, false) && event.character != 0;
    if (is_keeping_ && !is_own) kept_.push_back(event);
    if (is_keeping_) return !is_own;
    const KeyEvent key{labelled(event.key), modifiers_of(event.modifiers), event.action == GLFW_PRESS,
                       event.key};
    if (event.character == 0 && key.is_down && asks_for_field_ && asks_for_field_(key))
        is_keeping_ = is_own_character_ = true;
    return false;
}

std::vector<TypedEvent> WindowInput::release() {
    const auto ends = [](const TypedEvent& event) {
        const bool is_named =
            (event.key >= GLFW_KEY_ESCAPE && event.key <= GLFW_KEY_END) || event.key == GLFW_KEY_KP_ENTER;
        const bool is_command = is_named || (event.modifiers & GLFW_MOD_CONTROL);
        return event.character == 0 && is_command && event.action == GLFW_RELEASE;
    };
    auto end = std::ranges::find_if(kept_, ends);
    if (end != kept_.end()) ++end;
    std::vector<TypedEvent> released(kept_.begin(), end);
    kept_.erase(kept_.begin(), end);
    is_keeping_ = !kept_.empty();
    return released;
}

std::vector<Event> WindowInput::take() { return std::exchange(events_, {}); }

bool WindowInput::take_damage() { return std::exchange(is_damaged_, false); }

bool WindowInput::has_cancel() const {
    return std::ranges::any_of(events_, [](const Event& event) {
        const auto* key = std::get_if<KeyEvent>(&event);
        return std::holds_alternative<CloseEvent>(event)
               || (key && key->is_down && key->key == GLFW_KEY_ESCAPE);
    });
}

vec2 WindowInput::window_size() const {
    int width = 1, height = 1;
    glfwGetWindowSize(window_, &width, &height);
    return {static_cast<float>(std::max(1, width)), static_cast<float>(std::max(1, height))};
}

std::string WindowInput::clipboard() const {
    const char* text = glfwGetClipboardString(window_);
    return text ? text : "";
}

void WindowInput::set_clipboard(const std::string& text) { glfwSetClipboardString(window_, text.c_str()); }

bool WindowInput::is_down(int place) const { return glfwGetKey(window_, place) == GLFW_PRESS; }

vec2 WindowInput::pointer() const {
    double x = 0.0, y = 0.0;
    glfwGetCursorPos(window_, &x, &y);
    return {static_cast<float>(x), static_cast<float>(y)};
}

} // namespace sr::viewer
