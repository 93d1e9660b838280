#pragma once
// File dialog: a path is typed, chosen from a folder, or from recent files.
#include "viewer/ui.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace sr::viewer {

class FileDialog {
public:
    enum class Purpose { open, save, compare };

    /// Opens the dialog. `file`: the one that is proposed for saving, or whose folder is listed.
    void show(Purpose purpose, const std::string& file);
    void close() { is_open_ = is_waiting_ = false; }
    bool is_open() const { return is_open_; }
    /// True from the choice of a file until close() or retry().
    bool is_waiting() const { return is_open_ && is_waiting_; }
    /// Gives the keyboard back to the typed path, because the chosen file is of no use.
    void retry() {
        is_waiting_ = false;
        focus_.begin();
    }
    bool wants_focus() const { return focus_.is_pending(); }
    Purpose purpose() const { return purpose_; }

    /// Draws the dialog, if it is open. It stays open until close(). @return the chosen file, once
    std::optional<std::string> draw();

private:
    void type(const std::string& path);
    std::optional<std::string> draw_lists();

    bool is_open_ = false;
    bool is_waiting_ = false;
    FocusRequest focus_;
    Purpose purpose_ = Purpose::open;
    std::array<char, 1024> typed_{};
    std::vector<std::string> here_;   // in the folder of the current file
    std::vector<std::string> recent_; // recently opened
};

} // namespace sr::viewer
