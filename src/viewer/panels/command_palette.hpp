#pragma once
// Command palette: finds a command by a part of its name, and runs it.
#include "viewer/keymap.hpp"
#include "viewer/ui.hpp"

#include <array>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace sr::viewer {

/// Commands whose name, group or tooltip has every word of `typed`, in any case. Those that begin with it
/// come first, then those with all words in the name.
std::vector<const CommandInfo*> commands_like(std::string_view typed);

class CommandPalette {
public:
    void open();
    /// @return false if it was closed already
    bool close() { return std::exchange(is_open_, false); }
    bool is_open() const { return is_open_; }
    /// True while its field waits for the keyboard.
    bool wants_frame() const { return is_open_ && focus_.is_pending(); }

    /// Goes down by so many rows when it is drawn next.
    void move(int rows) { moves_ += rows; }

    /// Draws the palette, if it is open. @return the command that was chosen
    std::optional<Command> draw(const Ui& ui, const Keymap& keymap);

private:
    bool is_open_ = false;
    FocusRequest focus_;
    std::array<char, 128> typed_{};
    int chosen_ = 0; // row
    int moves_ = 0;  // of it, since the last frame
};

} // namespace sr::viewer
