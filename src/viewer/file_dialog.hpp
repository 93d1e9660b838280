#pragma once
// Which file to open, or under which name to save: typed, chosen from the folder, or from those opened last.
#include "viewer/focus.hpp"

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
    bool wants_focus() const { return focus_.is_open(); }
    Purpose purpose() const { return purpose_; }

    /// Draws it, if it is open. @return the file that was chosen, in the one frame in which it was
    std::optional<std::string> draw();

private:
    std::optional<std::string> draw_lists();

    bool is_open_ = false;
    FocusWish focus_;
    Purpose purpose_ = Purpose::open;
    std::array<char, 1024> typed_{};
    std::vector<std::string> here_;   // in the folder of the file at hand
    std::vector<std::string> recent_; // opened before
};

} // namespace sr::viewer
