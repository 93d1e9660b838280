#pragma once
// Help panel, status line and error panel.
#include <string>

namespace sr::viewer {

/// Parts of the status line.
struct Status {
    std::string progress;      // of the render
    std::string under_pointer; // radiance and luminance
    std::string message;       // the last one
};
void status_line(const Status& status);

/// Lists all keys and gestures, if `is_open`.
void help_panel(bool& is_open);

/// Shows an error over the picture.
void error_panel(const std::string& title, const std::string& text);

} // namespace sr::viewer
