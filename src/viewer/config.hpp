#pragma once
// Files of the viewer: settings that it remembers between two runs, names of screenshots.
#include <array>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace sr::viewer {

/// $XDG_CONFIG_HOME/steradian or ~/.config/steradian, which it creates. Empty if neither is possible; then
/// nothing is remembered.
std::filesystem::path config_folder();
/// The same for $XDG_STATE_HOME/steradian or ~/.local/state/steradian.
std::filesystem::path state_folder();
/// The same for $XDG_CACHE_HOME/steradian or ~/.cache/steradian.
std::filesystem::path cache_folder();

/// Writes a file whole or not at all. Failing, or an empty path, is no error. @return true if it is written
bool write_lines(const std::filesystem::path& file, const std::vector<std::string>& lines);

/// At most ten recent files, the newest first, without missing ones.
std::vector<std::string> recent_files();
void remember_file(const std::string& file);

/// Size of the window when it was last closed [screen coordinates]; {0, 0} if unknown.
struct WindowSize {
    int width = 0;
    int height = 0;
};
WindowSize remembered_size();
void remember_size(WindowSize size);

/// Panels when they were last changed.
struct PanelSettings {
    float column = 0.0f; // width of the left column [pixels, before scaling]; 0 if unknown
    bool are_shown = true;
};
PanelSettings remembered_panels();
void remember_panels(const PanelSettings& panels);

/// Returns whether a file has one of the extensions (".glb"), in letters of any case.
bool has_extension(const std::filesystem::path& file, std::span<const std::string_view> extensions);

inline constexpr std::array<std::string_view, 2> scene_extensions{".gltf", ".glb"};

/// The .gltf and .glb files in the folder of a file, sorted by name.
std::vector<std::string> scenes_beside(const std::string& file);

/// "STEM-001.EXT" in the working directory, or the first number after that is free.
std::string free_name(const std::string& scene_file, const std::string& extension);

/// The first free one of STEM_edited.EXT, STEM_edited2.EXT, …, beside the scene file.
std::string edited_name(const std::string& scene_file);

} // namespace sr::viewer
