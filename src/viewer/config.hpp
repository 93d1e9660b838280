#pragma once
// What the viewer remembers between two runs.
#include <filesystem>
#include <string>
#include <vector>

namespace sr::viewer {

/// $XDG_CONFIG_HOME/steradian, or ~/.config/steradian; made if it is not there. Empty if neither can be: then
/// nothing is remembered.
std::filesystem::path config_folder();

/// The files that were opened last, the newest first, at most ten; those that are gone are left out.
std::vector<std::string> recent_files();
void remember_file(const std::string& file);

/// The window's size when it was closed [screen coordinates]; {0, 0} if none is known.
struct WindowSize {
    int width = 0;
    int height = 0;
};
WindowSize remembered_size();
void remember_size(WindowSize size);

} // namespace sr::viewer
