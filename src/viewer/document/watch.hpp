#pragma once
// Watcher of files for changes, by polling.
#include <chrono>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace sr::viewer {

class Watch {
public:
    /// Watches these files, and all files in these folders and their subfolders. Their current state is no
    /// change.
    void set(std::vector<std::filesystem::path> places);

    /// Tells, once, that a file was saved, added or removed. Looks at most every 0.2 s.
    bool has_changed();

private:
    struct Stamp {
        std::filesystem::file_time_type time{};
        std::uintmax_t size = 0;
        std::filesystem::file_type type{}; // of the file itself: a link may lead nowhere
        std::filesystem::perms permissions{};

        bool operator==(const Stamp&) const = default;
    };
    using Stamps = std::map<std::filesystem::path, Stamp>;
    Stamps look() const;

    std::vector<std::filesystem::path> places_;
    Stamps seen_;
    std::chrono::steady_clock::time_point looked_{};
};

} // namespace sr::viewer
