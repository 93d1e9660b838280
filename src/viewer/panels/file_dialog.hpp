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

    void show(Purpose purpose, const std::string& near_file);
    void close() { is_open_ = false; }
    bool is_open() const { return is_open_; }
    bool wants_focus() const { return focus_.is_pending(); }
    Purpose purpose() const { return purpose_; }

    /// Draws the dialog, if it is open. @return the chosen file, once
    std::optional<std::string> draw();

private:
    std::optional<std::string> draw_lists();

    bool is_open_ = false;
    FocusRequest focus_;
    Purpose purpose_ = Purpose::open;
    std::array<char, 1024> typed_{};
    std::vector<std::string> here_;   // in the folder of the current file
    std::vector<std::string> recent_; // recently opened
};

} // namespace sr::viewer
