#pragma once
// Which key does what: one table for the keyboard, for the help and for tests.
#include <optional>
#include <span>

namespace sr::viewer {

enum class Command {
    orbit_left,
    orbit_right,
    orbit_up,
    orbit_down,
    pan_left,
    pan_right,
    pan_up,
    pan_down,
    dolly_in,
    dolly_out,
    roll_left,
    roll_right,
    level,
    frame_all,
    frame_selection,
    view_front,
    view_back,
    view_right,
    view_left,
    view_top,
    view_bottom,
    view_opposite,
    toggle_orthographic,
    narrower,
    wider,
    next_camera,
    file_camera,
    copy_view,
    paste_view,
    darker,
    brighter,
    auto_exposure,
    next_tone_curve,
    false_color,
    next_light,
    switch_light,
    solo_light,
    edit_light,
    delete_light,
    undo_light,
    redo_light,
    move_light,
    turn_light,
    scale_light,
    compare,
    ask,
    play,
    frame_back,
    frame_forward,
    first_frame,
    last_frame,
    next_variant,
    screenshot_png,
    screenshot_exr,
    turntable,
    open_file,
    save_as,
    reload,
    fullscreen,
    panels,
    help,
    cancel,
    quit,
};

/// Modifiers, as bits.
enum Modifier : int { no_modifier = 0, shift = 1, control = 2, alt = 4 };

struct Binding {
    int key = 0; // as GLFW numbers them
    int modifiers = no_modifier;
    Command command{};
    const char* keys = ""; // as the help shows them; empty: a second way, which the help leaves out
    const char* what = "";
    const char* group = "";
};

/// All of them, group by group.
std::span<const Binding> bindings();

/// What a key means with these modifiers; absent: nothing.
std::optional<Command> command_of(int key, int modifiers);

/// What the mouse does, for the help: pairs of gesture and meaning.
struct Gesture {
    const char* gesture = "";
    const char* what = "";
};
std::span<const Gesture> gestures();

} // namespace sr::viewer
