#pragma once
// File browser: a field for a path, and below it the folders and files that go on from what is typed.
#include "viewer/ui.hpp"

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

struct ImGuiInputTextCallbackData;

namespace sr::viewer {

class FileBrowser {
public:
    /// Lists folders, and files with one of these extensions. `typed`: in the field at first.
    void show(std::vector<std::string_view> extensions, const std::string& typed);
    /// Gives the keyboard to the field.
    void request_focus() { focus_.begin(); }
    bool wants_focus() const { return focus_.is_pending(); }
    /// Puts a path into the field.
    void type(const std::string& path);
    /// The path that Tab has completed, once; empty if it has completed none.
    std::string take_completed() { return std::exchange(completed_, {}); }

    /// Draws field and list. Tab completes a path, Enter chooses what is typed, or enters a folder.
    /// @return the chosen path, once
    std::optional<std::string> draw(const char* hint, float width, float list_height);

private:
    struct Entry {
        std::string name; // folders end in '/'
        bool is_folder = false;
    };

    static int call_back(ImGuiInputTextCallbackData* data);
    void complete(ImGuiInputTextCallbackData& data);
    void list(const char* typed);
    std::optional<std::string> draw_list(float width, float height);
    /// The path itself, unless it is a folder; then that is listed.
    std::optional<std::string> chosen_or_entered(const std::string& path);

    std::vector<std::string_view> extensions_;
    std::array<char, 1024> typed_{};
    FocusRequest focus_;
    int ends_left_ = 0;  // frames in which the cursor goes to the end: the field may select all twice
    std::string listed_; // the text that `entries_` go on from
    std::string folder_; // of `entries_`, as it was typed, with its last '/'
    std::vector<Entry> entries_;
    bool has_more_ = false; // entries than are listed
    std::string completed_;
};

/// Replaces a leading "~/" by the home folder.
std::filesystem::path expanded(const std::string& path);

} // namespace sr::viewer
