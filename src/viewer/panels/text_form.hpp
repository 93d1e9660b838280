#pragma once
// Form of text fields in a dialog, the first of which gets the keyboard.
#include "core/error.hpp"
#include "viewer/ui.hpp"

#include <array>
#include <optional>
#include <string>
#include <utility>

namespace sr::viewer {

/// Shows as a window in the middle, and reads what was entered when a button or Enter says so.
class TextForm {
public:
    using Text = std::array<char, 512>; // ends with 0

    static void put(Text& text, const std::string& value);

    /// The dialog opens.
    void begin();
    /// Shows what is wrong with what was entered, and requests the keyboard again.
    void refuse(const std::string& problem);

    bool wants_focus() const { return focus_.is_pending(); }
    /// The label of a field that got the keyboard, once; empty if none did.
    std::string take_focused() { return std::exchange(focused_, {}); }

    /// Draws a field. @return true if Enter was pressed in it
    bool field(const char* label, Text& text, const char* tip, bool is_first = false);

    /// Begins the window, whose fields come next.
    static void begin_window(const char* title, bool& is_open);
    /// Ends it with a button. @return true if that was pressed
    bool end_window(const char* button, const char* tip) const;
    /// Returns what `read` makes of the fields. If it throws Error, shows why, and returns none.
    template<class Read>
    auto taken(const Read& read) -> std::optional<decltype(read())> {
        try {
            problem_.clear();
            return read();
        } catch (const Error& error) {
            refuse(error.what());
            return std::nullopt;
        }
    }

private:
    FocusRequest focus_;
    std::string focused_;
    std::string problem_; // of what was entered last
};

} // namespace sr::viewer
