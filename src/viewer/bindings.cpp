#include "viewer/bindings.hpp"

#include <algorithm>
#include <array>
#include <cctype>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace sr::viewer {
namespace {

using enum Command;

constexpr auto table = std::to_array<CommandInfo>({
    {orbit_left, "Orbit left", "turn the view by 5° around the pivot", "Camera"},
    {orbit_right, "Orbit right", "turn the view by 5° around the pivot", "Camera"},
    {orbit_up, "Orbit up", "turn the view by 5° around the pivot", "Camera"},
    {orbit_down, "Orbit down", "turn the view by 5° around the pivot", "Camera"},
    {pan_left, "Pan left", "move the view by a twentieth of the picture's height", "Camera"},
    {pan_right, "Pan right", "move the view by a twentieth of the picture's height", "Camera"},
    {pan_up, "Pan up", "move the view by a twentieth of the picture's height", "Camera"},
    {pan_down, "Pan down", "move the view by a twentieth of the picture's height", "Camera"},
    {dolly_in, "Closer", "go a tenth closer to the pivot", "Camera"},
    {dolly_out, "Farther", "go a tenth farther from the pivot", "Camera"},
    {roll_left, "Roll left", "turn the picture by 5° around its centre", "Camera"},
    {roll_right, "Roll right", "turn the picture by 5° around its centre", "Camera"},
    {level, "Level", "remove roll", "Camera"},
    {frame_all, "Frame all", "show the whole scene", "Camera"},
    {frame_selection, "Frame selection", "show the selected lights or object, or the whole scene", "Camera"},
    {view_front, "View from the front", "look along -Z of the world", "Camera"},
    {view_back, "View from the back", "look along +Z of the world", "Camera"},
    {view_right, "View from the right", "look along -X of the world", "Camera"},
    {view_left, "View from the left", "look along +X of the world", "Camera"},
    {view_top, "View from the top", "look along -Y of the world", "Camera"},
    {view_bottom, "View from the bottom", "look along +Y of the world", "Camera"},
    {view_opposite, "Opposite view", "turn half around the pivot", "Camera"},
    {toggle_orthographic, "Orthographic", "switch between perspective and orthographic", "Camera"},
    {narrower, "Narrower field of view", "zoom in by the lens", "Camera"},
    {wider, "Wider field of view", "zoom out by the lens", "Camera"},
    {next_camera, "Next camera", "go to the file's next camera", "Camera"},
    {file_camera, "Back to the camera", "go back to the camera that the view began with", "Camera"},
    {type_camera, "Type the camera", "position, target and field of view, with units: 1.5 m; 35 deg; 50 mm",
     "Camera"},
    {keep_bookmark, "Keep the view", "as a bookmark of this file, which the next start knows", "Camera"},
    {next_bookmark, "Next bookmark", "go to the file's next bookmark", "Camera"},
    {earlier_view, "Earlier view", "go back to the view before; edits stay, which Undo takes back", "Camera"},
    {later_view, "Later view", "go forward again to the view after", "Camera"},
    {grid, "Grid and axes", "of the file's world, and how the view is turned; or hide them", "Camera"},
    {copy_view, "Copy the view", "copy the `steradian render` command that makes the same picture", "Camera"},
    {paste_view, "Paste a view", "go to a view that was copied", "Camera"},
    {darker, "Darker", "raise the exposure value by 1/3 EV", "Picture"},
    {brighter, "Brighter", "lower the exposure value by 1/3 EV", "Picture"},
    {auto_exposure, "Automatic exposure", "let the exposure follow the picture", "Picture"},
    {next_tone_curve, "Next tone curve", "show the picture by another curve", "Picture"},
    {false_color, "Luminance in false colours",
     "show luminance [cd/m²] on a colour map, or the picture again", "Picture"},
    {fit_range, "Fit the range", "give the false colours the range of luminance in the picture", "Picture"},
    {next_view, "Next view", "show another term of the equation", "Picture"},
    {next_light_alone, "Next light alone",
     "show the picture by one light after the other, then by all again; no edit", "Picture"},
    {next_background, "Next background",
     "where no surface is: black, grey, white, or as the command line has it", "Picture"},
    {compare, "Compare", "keep the render as the reference, then cycle through the comparisons with it",
     "Picture"},
    {keep_picture, "Keep the picture", "the render, with a letter, as the reference: up to eight pictures",
     "Picture"},
    {next_picture, "Next kept picture", "show A, B and so on in place of the render, then the render again",
     "Picture"},
    {next_reference, "Next reference", "compare with the next kept picture", "Picture"},
    {measure_pictures, "Measure the difference", "RMSE, relMSE, FLIP and more between the two pictures",
     "Picture"},
    {enlarge, "Enlarge pixels",
     "twice as large, around the pointer; also Ctrl and the wheel. Esc: as they are", "Picture"},
    {reduce, "Reduce pixels", "to half their size", "Picture"},
    {pixels, "Pixels", "loupe, statistics of a rectangle (Shift drag), histogram, pinned pixels", "Picture"},
    {pin_pixel, "Pin the pixel", "list the values of the pixel under the pointer until it is removed",
     "Picture"},
    {screenshot_png, "Write a PNG", "once the render has converged; twice: as it is now", "Picture"},
    {screenshot_exr, "Write an EXR", "radiance, once the render has converged; twice: as it is now",
     "Picture"},
    {screenshot_seen, "Write what is seen", "a PNG with wipe, difference or false colours", "Picture"},
    {copy_picture, "Copy the picture", "what is seen, as a PNG on the clipboard (by xclip or wl-copy)",
     "Picture"},
    {export_picture, "Export a picture", "of any size, with as many samples as asked for, as PNG or EXR",
     "Picture"},
    {turntable, "Write a turntable", "of a full turn around the pivot: PNGs or a video, any size and axis",
     "Picture"},
    {next_light, "Next light", "select the next light of the list", "Lights"},
    {switch_light, "Switch the light", "disable or enable the selected lights", "Lights"},
    {solo_light, "Light alone", "disable all but the selected lights, or enable all again", "Lights"},
    {edit_light, "Type a value", "of the selected lights: 800 lm, 6500 K, +1 EV", "Lights"},
    {brighten_light, "Brighten the light", "raise the selected lights by 1/3 EV", "Lights"},
    {dim_light, "Dim the light", "lower the selected lights by 1/3 EV", "Lights"},
    {mix_lights, "Light mixer", "faders, colours, mute and solo of all lights, which show at once", "Lights"},
    {add_light, "Add a light", "of any kind, as large and as bright as suits the scene", "Lights"},
    {duplicate_light, "Duplicate the light", "add copies of the selected lights beside them", "Lights"},
    {rename_light, "Rename the light", "type another name for the selected light", "Lights"},
    {delete_light, "Remove the light", "remove the selected lights", "Lights"},
    {undo_light, "Undo", "take back the last edit of a light or a material", "Lights"},
    {redo_light, "Redo", "make an edit again that was taken back", "Lights"},
    {move_light, "Move the light", "by the pointer or a number; X, Y, Z choose an axis", "Lights"},
    {turn_light, "Turn the light", "by the pointer or a number; X, Y, Z choose an axis", "Lights"},
    {scale_light, "Scale the light", "by the pointer or a number; X, Y, Z choose an extent", "Lights"},
    {scene_tree, "Scene", "list objects, materials, textures and what the file has; again: the next list",
     "Scene"},
    {inspect_pointed, "Inspect", "select the object under the pointer, and show its material", "Scene"},
    {hide_object, "Hide", "hide the selected object: it casts no shadow and emits nothing", "Scene"},
    {isolate_object, "Isolate", "hide all other objects, or show all again", "Scene"},
    {show_objects, "Show all", "show all hidden objects", "Scene"},
    {probe_pixel, "Probe", "evaluate the equation at the pixel under the pointer", "Equation"},
    {illuminance, "Illuminance", "on a plane: isolines, mean, extremes, uniformity; as CSV", "Equation"},
    {write_illuminance, "Write the illuminance", "the cells as CSV and the plan as SVG", "Equation"},
    {explain, "Explain", "show the equation with the pixel's numbers, and the code of each term", "Equation"},
    {next_term, "Next term", "explain the next term of the equation", "Equation"},
    {leave_out_term, "Leave the term out", "show the picture without it beside the picture, or take it back",
     "Equation"},
    {play, "Play or pause", "the animation; also Space while no light is selected", "Animation"},
    {frame_back, "Frame back", "go back by 1/24 s; Left alone over the bar", "Animation"},
    {frame_forward, "Frame forward", "go on by 1/24 s; Right alone over the bar", "Animation"},
    {first_frame, "First frame", "go to the start; Home alone over the bar", "Animation"},
    {last_frame, "Last frame", "go to the end; End alone over the bar", "Animation"},
    {next_variant, "Next variant", "show the next material variant of the file", "Animation"},
    {next_question, "Next question", "of the examination (view --tick)", "Examination"},
    {show_answer, "Show the answer", "of the question, or hide it", "Examination"},
    {try_question, "Try the question", "go to its pixel, or make its change and take it back", "Examination"},
    {times, "Time by part", "of a sample and of a frame; samples, shadow rays, memory", "Program"},
    {find_command, "All commands", "find a command by its name, and run it", "Program"},
    {open_file, "Open", "a glTF file; a file can be dropped on the window, too", "Program"},
    {next_file, "Next file", "open the next glTF file of the folder", "Program"},
    {previous_file, "Previous file", "open the glTF file before this one in the folder", "Program"},
    {save_as, "Save as", "write lights and view as a new glTF file", "Program"},
    {reload, "Reload", "read scene and shaders again", "Program"},
    {fullscreen, "Full screen", "fill the screen, or leave it", "Program"},
    {panels, "Panels", "hide or show all panels; the next start remembers it", "Program"},
    {messages, "Messages", "list all messages so far", "Program"},
    {help, "Keys", "list all keys and gestures", "Program"},
    {cancel, "Cancel", "close, deselect or cancel the innermost thing", "Program"},
    {quit, "Quit", "close the window; unsaved edits ask first", "Program"},
});

/// The first key of a command is the one that help and menus show.
constexpr auto keys = std::to_array<Binding>({
    {GLFW_KEY_LEFT, no_modifier, orbit_left},
    {GLFW_KEY_RIGHT, no_modifier, orbit_right},
    {GLFW_KEY_UP, no_modifier, orbit_up},
    {GLFW_KEY_DOWN, no_modifier, orbit_down},
    {GLFW_KEY_KP_4, no_modifier, orbit_left},
    {GLFW_KEY_KP_6, no_modifier, orbit_right},
    {GLFW_KEY_KP_8, no_modifier, orbit_up},
    {GLFW_KEY_KP_2, no_modifier, orbit_down},
    {GLFW_KEY_LEFT, shift, pan_left},
    {GLFW_KEY_RIGHT, shift, pan_right},
    {GLFW_KEY_UP, shift, pan_up},
    {GLFW_KEY_DOWN, shift, pan_down},
    {GLFW_KEY_PAGE_UP, no_modifier, dolly_in},
    {GLFW_KEY_PAGE_DOWN, no_modifier, dolly_out},
    {GLFW_KEY_KP_ADD, no_modifier, dolly_in},
    {GLFW_KEY_KP_SUBTRACT, no_modifier, dolly_out},
    {GLFW_KEY_LEFT_BRACKET, no_modifier, roll_left},
    {GLFW_KEY_RIGHT_BRACKET, no_modifier, roll_right},
    {GLFW_KEY_L, shift, level},
    {GLFW_KEY_A, no_modifier, frame_all},
    {GLFW_KEY_HOME, no_modifier, frame_all},
    {GLFW_KEY_F, no_modifier, frame_selection},
    {GLFW_KEY_KP_DECIMAL, no_modifier, frame_selection},
    {GLFW_KEY_1, no_modifier, view_front},
    {GLFW_KEY_3, no_modifier, view_right},
    {GLFW_KEY_7, no_modifier, view_top},
    {GLFW_KEY_KP_1, no_modifier, view_front},
    {GLFW_KEY_KP_3, no_modifier, view_right},
    {GLFW_KEY_KP_7, no_modifier, view_top},
    {GLFW_KEY_1, control, view_back},
    {GLFW_KEY_3, control, view_left},
    {GLFW_KEY_7, control, view_bottom},
    {GLFW_KEY_KP_1, control, view_back},
    {GLFW_KEY_KP_3, control, view_left},
    {GLFW_KEY_KP_7, control, view_bottom},
    {GLFW_KEY_9, no_modifier, view_opposite},
    {GLFW_KEY_KP_9, no_modifier, view_opposite},
    {GLFW_KEY_5, no_modifier, toggle_orthographic},
    {GLFW_KEY_KP_5, no_modifier, toggle_orthographic},
    {GLFW_KEY_MINUS, no_modifier, narrower},
    {GLFW_KEY_EQUAL, no_modifier, wider},
    {GLFW_KEY_0, no_modifier, file_camera},
    {GLFW_KEY_KP_0, no_modifier, file_camera},
    {GLFW_KEY_C, no_modifier, next_camera},
    {GLFW_KEY_C, shift, type_camera},
    {GLFW_KEY_B, control, keep_bookmark},
    {GLFW_KEY_B, shift, next_bookmark},
    {GLFW_KEY_BACKSPACE, no_modifier, earlier_view},
    {GLFW_KEY_BACKSPACE, shift, later_view},
    {GLFW_KEY_G, shift, grid},
    {GLFW_KEY_C, control, copy_view},
    {GLFW_KEY_V, control, paste_view},
    {GLFW_KEY_COMMA, no_modifier, darker},
    {GLFW_KEY_PERIOD, no_modifier, brighter},
    {GLFW_KEY_X, no_modifier, auto_exposure},
    {GLFW_KEY_T, no_modifier, next_tone_curve},
    {GLFW_KEY_Y, no_modifier, false_color},
    {GLFW_KEY_Y, shift, fit_range},
    {GLFW_KEY_V, no_modifier, next_view},
    {GLFW_KEY_V, shift, next_light_alone},
    {GLFW_KEY_B, alt, next_background},
    {GLFW_KEY_B, no_modifier, compare},
    {GLFW_KEY_K, control, keep_picture},
    {GLFW_KEY_K, shift, next_picture},
    {GLFW_KEY_K, control | shift, next_reference},
    {GLFW_KEY_K, alt, measure_pictures},
    {GLFW_KEY_Z, no_modifier, enlarge},
    {GLFW_KEY_Z, shift, reduce},
    {GLFW_KEY_W, no_modifier, pixels},
    {GLFW_KEY_W, shift, pin_pixel},
    {GLFW_KEY_F12, no_modifier, screenshot_png},
    {GLFW_KEY_F12, shift, screenshot_exr},
    {GLFW_KEY_F12, alt, screenshot_seen},
    {GLFW_KEY_C, control | shift, copy_picture},
    {GLFW_KEY_E, control, export_picture},
    {GLFW_KEY_F12, control, turntable},
    {GLFW_KEY_TAB, no_modifier, next_light},
    {GLFW_KEY_ENTER, no_modifier, edit_light},
    {GLFW_KEY_KP_ENTER, no_modifier, edit_light},
    {GLFW_KEY_SPACE, no_modifier, switch_light},
    {GLFW_KEY_SPACE, shift, solo_light},
    {GLFW_KEY_PERIOD, control, brighten_light},
    {GLFW_KEY_COMMA, control, dim_light},
    {GLFW_KEY_M, shift, mix_lights},
    {GLFW_KEY_A, shift, add_light},
    {GLFW_KEY_D, shift, duplicate_light},
    {GLFW_KEY_F2, no_modifier, rename_light},
    {GLFW_KEY_DELETE, no_modifier, delete_light},
    {GLFW_KEY_G, no_modifier, move_light},
    {GLFW_KEY_R, no_modifier, turn_light},
    {GLFW_KEY_S, no_modifier, scale_light},
    {GLFW_KEY_Z, control, undo_light},
    {GLFW_KEY_Z, control | shift, redo_light},
    {GLFW_KEY_Y, control, redo_light},
    {GLFW_KEY_O, no_modifier, scene_tree},
    {GLFW_KEY_O, shift, inspect_pointed},
    {GLFW_KEY_H, shift, hide_object},
    {GLFW_KEY_H, alt, show_objects},
    {GLFW_KEY_SLASH, no_modifier, isolate_object},
    {GLFW_KEY_P, no_modifier, probe_pixel},
    {GLFW_KEY_L, no_modifier, illuminance},
    {GLFW_KEY_L, control, write_illuminance},
    {GLFW_KEY_E, no_modifier, explain},
    {GLFW_KEY_E, shift, next_term},
    {GLFW_KEY_E, alt, leave_out_term},
    {GLFW_KEY_K, no_modifier, play},
    {GLFW_KEY_LEFT, alt, frame_back},
    {GLFW_KEY_RIGHT, alt, frame_forward},
    {GLFW_KEY_HOME, alt, first_frame},
    {GLFW_KEY_END, alt, last_frame},
    {GLFW_KEY_N, no_modifier, next_variant},
    {GLFW_KEY_J, no_modifier, next_question},
    {GLFW_KEY_U, no_modifier, show_answer},
    {GLFW_KEY_I, no_modifier, try_question},
    {GLFW_KEY_T, shift, times},
    {GLFW_KEY_O, control, open_file},
    {GLFW_KEY_PAGE_DOWN, control, next_file},
    {GLFW_KEY_PAGE_UP, control, previous_file},
    {GLFW_KEY_S, control, save_as},
    {GLFW_KEY_F5, no_modifier, reload},
    {GLFW_KEY_F11, no_modifier, fullscreen},
    {GLFW_KEY_H, no_modifier, panels},
    {GLFW_KEY_M, no_modifier, messages},
    {GLFW_KEY_F1, no_modifier, help},
    {GLFW_KEY_SLASH, shift, help},
    {GLFW_KEY_ESCAPE, no_modifier, cancel},
    {GLFW_KEY_Q, control, quit},
    {GLFW_KEY_P, control, find_command},
});

constexpr auto mouse = std::to_array<Gesture>({
    {"left or middle drag", "orbit"},
    {"Shift drag", "pan"},
    {"Ctrl drag, wheel", "closer, farther; the wheel towards the pointer"},
    {"Alt left, middle, right", "orbit, pan, closer: as in Maya"},
    {"right drag", "look around; with W A S D, Q E: fly (Shift: faster)"},
    {"two fingers", "closer, farther; sideways: pan"},
    {"click", "select a light, or probe the pixel"},
    {"Ctrl or Shift click", "add a light to the selection, or take it away"},
    {"in the list of lights", "Ctrl click likewise; Shift click, Shift Up, Shift Down: all up to there"},
    {"drop a file", "open a glTF; compare with an EXR, HDR, PNG or JPEG"},
    {"arrow, ring, square", "move, turn, resize the light; Ctrl: in steps"},
});

/// Names of keys without a letter, digit or sign of their own.
constexpr auto names = std::to_array<std::pair<int, const char*>>({
    {GLFW_KEY_LEFT, "Left"},           {GLFW_KEY_RIGHT, "Right"},       {GLFW_KEY_UP, "Up"},
    {GLFW_KEY_DOWN, "Down"},           {GLFW_KEY_PAGE_UP, "PgUp"},      {GLFW_KEY_PAGE_DOWN, "PgDn"},
    {GLFW_KEY_HOME, "Home"},           {GLFW_KEY_END, "End"},           {GLFW_KEY_TAB, "Tab"},
    {GLFW_KEY_ENTER, "Enter"},         {GLFW_KEY_SPACE, "Space"},       {GLFW_KEY_DELETE, "Delete"},
    {GLFW_KEY_BACKSPACE, "Backspace"}, {GLFW_KEY_INSERT, "Insert"},     {GLFW_KEY_ESCAPE, "Esc"},
    {GLFW_KEY_KP_ADD, "Num +"},        {GLFW_KEY_KP_SUBTRACT, "Num -"}, {GLFW_KEY_KP_DECIMAL, "Num ."},
    {GLFW_KEY_KP_ENTER, "Num Enter"},
});

std::string name_of_key(int key) {
    if (const auto found = std::ranges::find(names, key, &std::pair<int, const char*>::first);
        found != names.end())
        return found->second;
    if (key >= GLFW_KEY_KP_0 && key <= GLFW_KEY_KP_9) return "Num " + std::to_string(key - GLFW_KEY_KP_0);
    if (key >= GLFW_KEY_F1 && key <= GLFW_KEY_F25) return "F" + std::to_string(key - GLFW_KEY_F1 + 1);
    return std::string(1, static_cast<char>(key)); // GLFW numbers printable keys as ASCII does
}

/// True for a key that name_of_key() names.
bool is_known(int key) {
    const bool is_printable = key > GLFW_KEY_SPACE && key <= GLFW_KEY_GRAVE_ACCENT;
    return is_printable || (key >= GLFW_KEY_KP_0 && key <= GLFW_KEY_KP_9)
           || (key >= GLFW_KEY_F1 && key <= GLFW_KEY_F25)
           || std::ranges::find(names, key, &std::pair<int, const char*>::first) != names.end();
}

bool same_letters(std::string_view a, std::string_view b) {
    return std::ranges::equal(
        a, b, [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

} // namespace

std::span<const CommandInfo> all_commands() { return table; }
std::span<const Binding> bindings() { return keys; }

std::string keys_of(const Binding& binding) {
    std::string text;
    if (binding.modifiers & control) text += "Ctrl ";
    if (binding.modifiers & alt) text += "Alt ";
    if (binding.modifiers & shift) text += "Shift ";
    return text + name_of_key(binding.key);
}

std::optional<std::pair<int, int>> parse_key(std::string_view text) {
    int modifiers = no_modifier;
    const auto take = [&](std::string_view word, int modifier) {
        const bool is_next = text.size() > word.size() + 1 && same_letters(text.substr(0, word.size()), word)
                             && (text[word.size()] == ' ' || text[word.size()] == '+');
        if (!is_next) return false;
        text.remove_prefix(word.size() + 1);
        modifiers |= modifier;
        return true;
    };
    while (take("Ctrl", control) || take("Alt", alt) || take("Shift", shift)) {
    }
    for (int key = 0; key <= GLFW_KEY_LAST; ++key)
        if (is_known(key) && same_letters(text, name_of_key(key))) return std::pair(key, modifiers);
    return std::nullopt;
}

const CommandInfo& info_of(Command command) {
    return *std::ranges::find(table, command, &CommandInfo::command);
}

bool works_in_text_fields(Command command) {
    switch (command) {
    case quit:
    case find_command:
    case open_file:
    case next_file:
    case previous_file:
    case save_as:
    case reload:
    case fullscreen:
    case cancel: return true;
    default: return false;
    }
}

bool changes_scene(Command command) {
    switch (command) {
    case false_color:
    case next_view:
    case next_light_alone:
    case next_background:
    case switch_light:
    case solo_light:
    case edit_light:
    case brighten_light:
    case dim_light:
    case mix_lights:
    case add_light:
    case duplicate_light:
    case rename_light:
    case delete_light:
    case move_light:
    case turn_light:
    case scale_light:
    case undo_light:
    case redo_light:
    case hide_object:
    case isolate_object:
    case show_objects:
    case leave_out_term:
    case play:
    case frame_back:
    case frame_forward:
    case first_frame:
    case last_frame:
    case next_variant:
    case try_question:
    case reload: return true;
    default: return false;
    }
}

bool opens_text_field(Command command) {
    switch (command) {
    case find_command:
    case open_file:
    case save_as:
    case type_camera:
    case export_picture:
    case turntable:
    case edit_light:
    case rename_light: return true;
    default: return false;
    }
}

std::span<const Gesture> gestures() { return mouse; }

} // namespace sr::viewer
