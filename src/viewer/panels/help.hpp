#pragma once
// Help panel, message area with its history, and error panel.
#include "viewer/app/layout.hpp"
#include "viewer/keymap.hpp"

#include <string>
#include <vector>

namespace sr::viewer {

/// Parts of the message area.
struct Status {
    std::string progress;      // of the render
    std::string under_pointer; // radiance and luminance
    std::string message;       // the last one
};
/// Draws the message area at the lower edge of the window, as high as its text needs.
void message_area(const Status& status, Layout& layout);

/// Lists the messages so far, if `is_open`.
void history_panel(bool& is_open, const std::vector<std::string>& messages);

/// Lists all commands with their keys, and all gestures, if `is_open`.
void help_panel(bool& is_open, const Keymap& keys);

/// Shows an error over the picture.
void error_panel(const std::string& title, const std::string& text);

} // namespace sr::viewer
