#pragma once
// Bookmarks: views that a person keeps, of each scene file.
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace sr::viewer {

struct Bookmark {
    std::string name;
    std::string look_at; // as scene::parse_look_at() reads it

    bool operator==(const Bookmark&) const = default;
};

/// Views of one scene file, kept in bookmarks.json of state_folder(), which has those of all files. A file
/// that cannot be read has none, and what cannot be written is kept for this run only (is_stored()).
class Bookmarks {
public:
    /// `store`: empty for state_folder().
    explicit Bookmarks(const std::string& scene_file, std::filesystem::path store = {});

    const std::string& scene_file() const { return scene_file_; }
    const std::vector<Bookmark>& all() const { return all_; }

    /// Keeps a view under the first free name "view N". @return the name
    const std::string& keep(const std::string& look_at);
    void remove(std::size_t index);
    /// False if the last change could not be written.
    bool is_stored() const { return is_stored_; }

private:
    void write();

    std::string scene_file_;
    std::string key_; // whole path of the scene file
    std::filesystem::path store_;
    std::vector<Bookmark> all_;
    bool is_stored_ = true;
};

} // namespace sr::viewer
