#pragma once
// Commands and their keys: the tables that the keyboard, the help, the menus and the palette read.
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

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
    type_camera,
    keep_bookmark,
    next_bookmark,
    earlier_view,
    later_view,
    grid,
    copy_view,
    paste_view,
    darker,
    brighter,
    auto_exposure,
    next_tone_curve,
    false_color,
    fit_range,
    next_view,
    next_light_alone,
    next_background,
    next_light,
    switch_light,
    solo_light,
    edit_light,
    brighten_light,
    dim_light,
    mix_lights,
    add_light,
    duplicate_light,
    rename_light,
    delete_light,
    scene_tree,
    inspect_pointed,
    hide_object,
    isolate_object,
    show_objects,
    undo_light,
    redo_light,
    move_light,
    turn_light,
    scale_light,
    compare,
    keep_picture,
    next_picture,
    next_reference,
    measure_pictures,
    enlarge,
    reduce,
    pixels,
    pin_pixel,
    probe_pixel,
    illuminance,
    write_illuminance,
    explain,
    next_term,
    leave_out_term,
    play,
    frame_back,
    frame_forward,
    first_frame,
    last_frame,
    next_variant,
    next_question,
    show_answer,
    try_question,
    screenshot_png,
    screenshot_exr,
    screenshot_seen,
    copy_picture,
    export_picture,
    turntable,
    times,
    find_command,
    open_file,
    next_file,
    previous_file,
    save_as,
    reload,
    fullscreen,
    panels,
    messages,
    help,
    cancel,
    quit,
};

/// Modifiers, as bits.
enum Modifier : int { no_modifier = 0, shift = 1, control = 2, alt = 4 };

struct CommandInfo {
    Command command{};
    const char* name = ""; // in menus and the palette
    const char* what = ""; // the tooltip
    const char* group = "";
};

/// All commands, group by group.
std::span<const CommandInfo> all_commands();

/// The row of a command.
const CommandInfo& info_of(Command command);

struct Binding {
    int key = 0; // as GLFW numbers them
    int modifiers = no_modifier;
    Command command{};
};

/// The built-in keys. A command can have several.
std::span<const Binding> bindings();

/// "Ctrl Shift Z".
std::string keys_of(const Binding& binding);
/// Reads "Ctrl Shift Z" or "ctrl+shift+z". @return key and modifiers; absent if it is no key
std::optional<std::pair<int, int>> parse_key(std::string_view text);

/// True if a key of the command also works while a text field has the keyboard.
bool works_in_text_fields(Command command);

/// True for a command that changes what the render shows, and not only from where or how it is displayed.
bool changes_scene(Command command);

/// True for a command that opens a text field, which is to have what is typed next.
bool opens_text_field(Command command);

/// Gestures of the mouse, for the help.
struct Gesture {
    const char* gesture = "";
    const char* what = "";
};
std::span<const Gesture> gestures();

} // namespace sr::viewer
