#include "viewer/config.hpp"

#include "core/error.hpp"
#include "core/file.hpp"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <fmt/format.h>
#include <fstream>
#include <sstream>

namespace sr::viewer {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> lines_of(const fs::path& file) {
    std::vector<std::string> lines;
    try {
        std::istringstream in(read_text(file));
        for (std::string line; std::getline(in, line);) lines.push_back(line);
    } catch (const Error&) { // there is none yet
    }
    return lines;
}

fs::path file_named(const char* name) {
    const fs::path folder = config_folder();
    return folder.empty() ? folder : folder / name;
}

/// The folder that an environment variable names, or else one in the home folder.
fs::path folder_named(const char* variable, const char* in_home) {
    const char* named = std::getenv(variable);
    const char* home = std::getenv("HOME");
    fs::path folder;
    if (named && *named)
        folder = named;
    else if (home && *home)
        folder = fs::path(home) / in_home;
    else
        return {};
    folder /= "steradian";
    std::error_code failure;
    fs::create_directories(folder, failure);
    return failure ? fs::path{} : folder;
}

} // namespace

bool write_lines(const fs::path& file, const std::vector<std::string>& lines) {
    if (file.empty()) return false;
    std::error_code failure;
    const fs::path unfinished = file.string() + ".tmp";
    {
        std::ofstream out(unfinished);
        for (const std::string& line : lines) out << line << '\n';
        out.close(); // only then it is known that all of them fit on the disk
        if (!out) {
            fs::remove(unfinished, failure);
            return false;
        }
    }
    fs::rename(unfinished, file, failure);
    return !failure;
}

fs::path config_folder() { return folder_named("XDG_CONFIG_HOME", ".config"); }
fs::path cache_folder() { return folder_named("XDG_CACHE_HOME", ".cache"); }
fs::path state_folder() { return folder_named("XDG_STATE_HOME", ".local/state"); }

std::vector<std::string> recent_files() {
    std::vector<std::string> files = lines_of(file_named("recent"));
    std::error_code ignored;
    std::erase_if(files, [&](const std::string& file) { return !fs::exists(file, ignored); });
    return files;
}

void remember_file(const std::string& file) {
    constexpr std::size_t max_files = 10;
    std::error_code failure;
    const std::string whole = fs::absolute(file, failure).lexically_normal().string();
    if (failure) return;
    std::vector<std::string> files = recent_files();
    std::erase(files, whole);
    files.insert(files.begin(), whole);
    files.resize(std::min(files.size(), max_files));
    write_lines(file_named("recent"), files);
}

WindowSize remembered_size() {
    WindowSize size;
    const std::vector<std::string> lines = lines_of(file_named("window"));
    if (!lines.empty()) std::istringstream(lines.front()) >> size.width >> size.height;
    const auto is_sensible = [](int side) { return side >= 64 && side <= 16384; };
    return is_sensible(size.width) && is_sensible(size.height) ? size : WindowSize{};
}

void remember_size(WindowSize size) {
    write_lines(file_named("window"), {std::to_string(size.width) + " " + std::to_string(size.height)});
}

PanelSettings remembered_panels() {
    PanelSettings panels;
    const std::vector<std::string> lines = lines_of(file_named("panels"));
    if (!lines.empty()) std::istringstream(lines.front()) >> panels.column >> panels.are_shown;
    constexpr float widest = 4096.0f;
    return panels.column >= 0.0f && panels.column <= widest ? panels : PanelSettings{};
}

void remember_panels(const PanelSettings& panels) {
    write_lines(file_named("panels"), {fmt::format("{:.0f} {:d}", panels.column, panels.are_shown)});
}

bool has_extension(const fs::path& file, std::span<const std::string_view> extensions) {
    std::string extension = file.extension().string();
    std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return std::tolower(c); });
    return std::ranges::find(extensions, extension) != extensions.end();
}

std::vector<std::string> scenes_beside(const std::string& file) {
    std::vector<std::string> files;
    const fs::path path(file);
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    std::error_code failure;
    for (fs::directory_iterator entry(folder, failure); !failure && entry != fs::directory_iterator();
         entry.increment(failure)) {
        if (has_extension(entry->path(), scene_extensions)) files.push_back(entry->path().string());
    }
    std::ranges::sort(files);
    return files;
}

std::string free_name(const std::string& scene_file, const std::string& extension) {
    const std::string stem = std::filesystem::path(scene_file).stem().string();
    for (int number = 1;; ++number) {
        std::string name = fmt::format("{}-{:03}{}", stem, number, extension);
        std::error_code ignored;
        if (!std::filesystem::exists(name, ignored)) return name;
    }
}

std::string edited_name(const std::string& scene_file) {
    const fs::path file(scene_file);
    for (int number = 1;; ++number) {
        const std::string suffix = number == 1 ? "_edited" : fmt::format("_edited{}", number);
        const fs::path name =
            file.parent_path() / (file.stem().string() + suffix + file.extension().string());
        std::error_code ignored;
        if (!fs::exists(name, ignored)) return name.string();
    }
}

} // namespace sr::viewer
