#pragma once
// Form of text fields in a dialog, the first of which gets the keyboard.
#include "viewer/ui.hpp"

#include <array>
#include <string>
#include <utility>

namespace sr::viewer {

class TextForm {
public:
    using Text = std::array<char, 512>; // ends with 0

    static void put(Text& text, const std::string& value);

    /// The dialog opens.
    void begin();
    /// Shows what is wrong with what was entered, and requests the keyboard again.
    void refuse(const std::string& problem);
    void accept() { problem_.clear(); }

    bool wants_focus() const { return focus_.is_pending(); }
    /// The label of a field that got the keyboard, once; empty if none did.
    std::string take_focused() { return std::exchange(focused_, {}); }

    /// Draws a field. @return true if Enter was pressed in it
    bool field(const char* label, Text& text, const char* tip, bool is_first = false);
    void draw_problem() const;

private:
    FocusRequest focus_;
    std::string focused_;
    std::string problem_; // of what was entered last
};

} // namespace sr::viewer
