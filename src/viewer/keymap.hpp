#pragma once
// Keys of commands in use: the built-in ones, and those that a person gives them in a file.
#include "viewer/bindings.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace sr::viewer {

class Keymap {
public:
    /// The built-in keys.
    Keymap();

    /// The built-in keys, but for the commands that a JSON file names: {"Frame all": "Ctrl Home", "Pixels":
    /// ["W", "F9"], "Write a turntable": []}. @throws Error with line and column for an unknown command or
    /// key, and for a key of two commands
    static Keymap read(const std::filesystem::path& file);

    /// Those of keys_file(), or the built-in ones where nothing has its name. @throws Error as read() does,
    /// also for a folder, and for a link that leads nowhere or in a circle
    static Keymap in_use();

    std::span<const Binding> all() const { return bindings_; }
    /// The first key of a command, "Ctrl Shift Z"; empty if it has none.
    std::string text(Command command) const;
    /// `what` with the command's key: "hide the selected object (Shift H)".
    std::string hint(std::string_view what, Command command) const;
    /// The command of a key with these modifiers; absent if it has none.
    std::optional<Command> command_of(int key, int modifiers) const;

    /// All commands with their keys, in the form of read().
    std::string json() const;

private:
    std::vector<Binding> bindings_; // command by command, the one to show first
};

/// keys.json in the config folder; empty without such a folder.
std::filesystem::path keys_file();

} // namespace sr::viewer
