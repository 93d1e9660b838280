#pragma once
// Journal of unsaved edits: a file that outlives a crash of the viewer.
#include "viewer/document/light_edits.hpp"

#include <filesystem>
#include <optional>

namespace sr::viewer {

/// Edits of a run that ended without saving them.
struct LostEdits {
    std::filesystem::path journal;
    std::vector<LightEdit> edits;       // all of the editor, edited and not
    std::size_t count = 0;              // of those that the journal changes
    bool has_file_changed = false;      // since: lights and materials are found by their names
    std::vector<std::string> missing{}; // names of those that are not found; "" where they have none
};

struct FoundJournals {
    std::optional<LostEdits> newest;
    std::vector<std::string> problems; // one line each: a journal cannot be read
};

/// A file in $XDG_STATE_HOME/steradian (or ~/.local/state/steradian) for each scene file and run. A lock
/// beside it is held while the run lives; the system releases it when the run ends in any way. What cannot be
/// written is not kept; write() tells it.
class Journal {
public:
    explicit Journal(const std::string& scene_file);
    ~Journal();
    Journal(const Journal&) = delete;
    Journal& operator=(const Journal&) = delete;

    const std::string& scene_file() const { return scene_file_; }

    /// Finds the newest journal of the scene file whose run has ended. `fresh`: the edits of the file as it
    /// is; `json_hash`: its (gltf::SourceFile). In a file with another hash a light or a material is found by
    /// its name, if no other one has that name. A damaged journal is moved aside, so that it is reported
    /// once.
    FoundJournals find(const std::vector<LightEdit>& fresh, std::size_t json_hash) const;

    /// Writes the edits that the file, which has this hash, does not have; removes the journal if there are
    /// none. @return false if there are some, and they could not be written
    bool write(const LightEditor& editor, std::size_t json_hash) const;
    void remove() const;

private:
    std::string scene_file_;
    std::filesystem::path file_; // empty: there is no place for it
    std::string prefix_;         // of the names of all journals of the scene file
    int lock_ = -1;              // descriptor of the lock of file_
};

} // namespace sr::viewer
