#pragma once
// Small pictures of scene files, which child processes render one after the other, and which stay in the
// cache folder.
#include <chrono>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace sr::viewer {

class Thumbnails {
public:
    static constexpr int width = 160, height = 90; // [pixels]

    /// Begins to make those of `files` that are not in the cache yet, or whose file has changed. `folder`: of
    /// the cache. If nothing can be written there, nothing is made, and problem() says so.
    Thumbnails(const std::vector<std::string>& files, std::filesystem::path folder);
    /// Stops the process at work.
    ~Thumbnails();
    Thumbnails(const Thumbnails&) = delete;
    Thumbnails& operator=(const Thumbnails&) = delete;

    /// Looks after the process at work, and starts the next one. @return true if there is another picture or
    /// another fault
    bool update();
    bool is_working() const { return process_ > 0 || !wanted_.empty(); }

    /// The PNG of a file; empty if there is none, or none yet.
    std::filesystem::path picture_of(const std::string& file) const;
    /// Says why a file has no picture and gets none; empty otherwise.
    std::string fault_of(const std::string& file) const;
    /// Says why no pictures are made; empty if they are.
    const std::string& problem() const { return problem_; }

private:
    using Clock = std::chrono::steady_clock;

    void start();
    void stop();
    void end(int status);

    std::filesystem::path folder_;
    std::string problem_;
    std::map<std::string, std::filesystem::path> pictures_; // of files that have one
    std::map<std::string, std::string> faults_;             // of files that get none
    std::vector<std::string> wanted_;                       // the next one last
    std::string file_;                                      // at work
    int process_ = 0;                                       // that renders it; 0: none
    Clock::time_point begun_{};
};

} // namespace sr::viewer
