#pragma once
// File dialog: a path is typed, chosen from a folder, or from recent files.
#include "viewer/panels/file_browser.hpp"

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
        browser_.request_focus();
    }
    bool wants_focus() const { return browser_.wants_focus(); }
    Purpose purpose() const { return purpose_; }

    /// Draws the dialog, if it is open. It stays open until close(). @return the chosen file, once
    std::optional<std::string> draw();

private:
    std::optional<std::string> draw_recent();

    bool is_open_ = false;
    bool is_waiting_ = false;
    Purpose purpose_ = Purpose::open;
    FileBrowser browser_;
    std::vector<std::string> recent_; // recently opened
};

} // namespace sr::viewer
