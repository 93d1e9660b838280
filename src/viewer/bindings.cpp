#include "viewer/bindings.hpp"

#include <algorithm>
#include <array>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace sr::viewer {
namespace {

using enum Command;

constexpr auto table = std::to_array<Binding>({
    {GLFW_KEY_LEFT, 0, orbit_left, "arrows", "orbit by 5 degrees", "Camera"},
    {GLFW_KEY_RIGHT, 0, orbit_right},
    {GLFW_KEY_UP, 0, orbit_up},
    {GLFW_KEY_DOWN, 0, orbit_down},
    {GLFW_KEY_KP_4, 0, orbit_left},
    {GLFW_KEY_KP_6, 0, orbit_right},
    {GLFW_KEY_KP_8, 0, orbit_up},
    {GLFW_KEY_KP_2, 0, orbit_down},
    {GLFW_KEY_LEFT, shift, pan_left, "Shift arrows", "pan", "Camera"},
    {GLFW_KEY_RIGHT, shift, pan_right},
    {GLFW_KEY_UP, shift, pan_up},
    {GLFW_KEY_DOWN, shift, pan_down},
    {GLFW_KEY_PAGE_UP, 0, dolly_in, "PgUp, PgDn", "closer, farther", "Camera"},
    {GLFW_KEY_PAGE_DOWN, 0, dolly_out},
    {GLFW_KEY_KP_ADD, 0, dolly_in},
    {GLFW_KEY_KP_SUBTRACT, 0, dolly_out},
    {GLFW_KEY_LEFT_BRACKET, 0, roll_left, "[ ]", "roll", "Camera"},
    {GLFW_KEY_RIGHT_BRACKET, 0, roll_right},
    {GLFW_KEY_L, shift, level, "Shift L", "remove roll", "Camera"},
    {GLFW_KEY_A, 0, frame_all, "A, Home", "frame all", "Camera"},
    {GLFW_KEY_HOME, 0, frame_all},
    {GLFW_KEY_F, 0, frame_selection, "F", "frame the selected light, or all", "Camera"},
    {GLFW_KEY_KP_DECIMAL, 0, frame_selection},
    {GLFW_KEY_1, 0, view_front, "1 3 7", "front, right, top (numpad, too)", "Camera"},
    {GLFW_KEY_3, 0, view_right},
    {GLFW_KEY_7, 0, view_top},
    {GLFW_KEY_KP_1, 0, view_front},
    {GLFW_KEY_KP_3, 0, view_right},
    {GLFW_KEY_KP_7, 0, view_top},
    {GLFW_KEY_1, control, view_back, "Ctrl 1 3 7", "back, left, bottom", "Camera"},
    {GLFW_KEY_3, control, view_left},
    {GLFW_KEY_7, control, view_bottom},
    {GLFW_KEY_KP_1, control, view_back},
    {GLFW_KEY_KP_3, control, view_left},
    {GLFW_KEY_KP_7, control, view_bottom},
    {GLFW_KEY_9, 0, view_opposite, "9", "the opposite view", "Camera"},
    {GLFW_KEY_KP_9, 0, view_opposite},
    {GLFW_KEY_5, 0, toggle_orthographic, "5", "perspective or orthographic", "Camera"},
    {GLFW_KEY_KP_5, 0, toggle_orthographic},
    {GLFW_KEY_MINUS, 0, narrower, "- =", "narrower, wider field of view", "Camera"},
    {GLFW_KEY_EQUAL, 0, wider},
    {GLFW_KEY_0, 0, file_camera, "0", "back to the file's camera", "Camera"},
    {GLFW_KEY_KP_0, 0, file_camera},
    {GLFW_KEY_C, 0, next_camera, "C", "the file's next camera", "Camera"},
    {GLFW_KEY_C, control, copy_view, "Ctrl C", "copy the view as arguments of render", "Camera"},
    {GLFW_KEY_V, control, paste_view, "Ctrl V", "go to a copied view", "Camera"},
    {GLFW_KEY_COMMA, 0, darker, ", .", "darker, brighter by 1/3 EV", "Picture"},
    {GLFW_KEY_PERIOD, 0, brighter},
    {GLFW_KEY_X, 0, auto_exposure, "X", "automatic exposure", "Picture"},
    {GLFW_KEY_T, 0, next_tone_curve, "T", "next tone curve", "Picture"},
    {GLFW_KEY_Y, 0, false_color, "Y", "luminance as false colour", "Picture"},
    {GLFW_KEY_V, 0, next_view, "V", "next view: one term of the equation", "Picture"},
    {GLFW_KEY_B, 0, compare, "B", "keep a reference, then compare with it", "Picture"},
    {GLFW_KEY_F12, 0, screenshot_png, "F12", "write a PNG, once converged (twice: as it is)", "Picture"},
    {GLFW_KEY_F12, shift, screenshot_exr, "Shift F12", "write an EXR, likewise", "Picture"},
    {GLFW_KEY_F12, alt, screenshot_seen, "Alt F12", "write a PNG of what is seen, wipe or difference",
     "Picture"},
    {GLFW_KEY_F12, control, turntable, "Ctrl F12", "write a turntable of PNGs", "Picture"},
    {GLFW_KEY_TAB, 0, next_light, "Tab", "select the next light", "Lights"},
    {GLFW_KEY_ENTER, 0, edit_light, "Enter", "type its value: 800 lm, 6500 K", "Lights"},
    {GLFW_KEY_KP_ENTER, 0, edit_light},
    {GLFW_KEY_SPACE, 0, switch_light, "Space", "disable, enable it", "Lights"},
    {GLFW_KEY_SPACE, shift, solo_light, "Shift Space", "enable it alone", "Lights"},
    {GLFW_KEY_DELETE, 0, delete_light, "Delete", "remove it", "Lights"},
    {GLFW_KEY_G, 0, move_light, "G R S", "move, turn, scale it; then X Y Z or a number", "Lights"},
    {GLFW_KEY_R, 0, turn_light},
    {GLFW_KEY_S, 0, scale_light},
    {GLFW_KEY_Z, control, undo_light, "Ctrl (Shift) Z", "undo, redo an edit of a light", "Lights"},
    {GLFW_KEY_Z, control | shift, redo_light},
    {GLFW_KEY_Y, control, redo_light},
    {GLFW_KEY_P, 0, probe_pixel, "P", "probe the pixel under the pointer", "Lights"},
    {GLFW_KEY_K, 0, play, "K, Space", "play, pause (Space: no light selected)", "Animation"},
    {GLFW_KEY_LEFT, alt, frame_back, "Alt left, right", "a frame back, forward (over the bar without Alt)",
     "Animation"},
    {GLFW_KEY_RIGHT, alt, frame_forward},
    {GLFW_KEY_HOME, alt, first_frame, "Alt Home, End", "to the start, the end (likewise)", "Animation"},
    {GLFW_KEY_END, alt, last_frame},
    {GLFW_KEY_N, 0, next_variant, "N", "the next material variant", "Animation"},
    {GLFW_KEY_J, 0, next_question, "J", "the next question of --tick", "Examination"},
    {GLFW_KEY_U, 0, show_answer, "U", "show, hide its answer", "Examination"},
    {GLFW_KEY_I, 0, try_question, "I", "go to its pixel, or make its change and take it back", "Examination"},
    {GLFW_KEY_O, control, open_file, "Ctrl O", "open a file, or drop it here", "Program"},
    {GLFW_KEY_S, control, save_as, "Ctrl S", "save lights and view as a new glTF", "Program"},
    {GLFW_KEY_F5, 0, reload, "F5", "reload scene and shaders", "Program"},
    {GLFW_KEY_F11, 0, fullscreen, "F11", "full screen", "Program"},
    {GLFW_KEY_H, 0, panels, "H", "hide or show the panels", "Program"},
    {GLFW_KEY_M, 0, messages, "M", "all messages so far", "Program"},
    {GLFW_KEY_F1, 0, help, "F1, ?", "this help", "Program"},
    {GLFW_KEY_SLASH, shift, help},
    {GLFW_KEY_ESCAPE, 0, cancel, "Esc", "close, deselect, cancel", "Program"},
    {GLFW_KEY_Q, control, quit, "Ctrl Q", "quit", "Program"},
});

constexpr auto mouse = std::to_array<Gesture>({
    {"left or middle drag", "orbit"},
    {"Shift drag", "pan"},
    {"Ctrl drag, wheel", "closer, farther; the wheel towards the pointer"},
    {"Alt left, middle, right", "orbit, pan, closer: as in Maya"},
    {"right drag", "look around; with W A S D, Q E: fly (Shift: faster)"},
    {"two fingers", "closer, farther; sideways: pan"},
    {"click", "select a light, or probe the pixel"},
    {"drop a file", "open a glTF; compare with an EXR, HDR, PNG or JPEG"},
    {"arrow, ring, square", "move, turn, resize the light; Ctrl: in steps"},
});

} // namespace

std::span<const Binding> bindings() { return table; }

std::optional<Command> command_of(int key, int modifiers) {
    const auto found = std::ranges::find_if(
        table, [=](const Binding& b) { return b.key == key && b.modifiers == modifiers; });
    return found == table.end() ? std::nullopt : std::optional(found->command);
}

bool works_in_text_fields(Command command) {
    switch (command) {
    case quit:
    case open_file:
    case save_as:
    case reload:
    case fullscreen:
    case cancel: return true;
    default: return false;
    }
}

std::span<const Gesture> gestures() { return mouse; }

} // namespace sr::viewer
