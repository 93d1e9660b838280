#pragma once
// Progress of long work, on stderr.
#include <chrono>
#include <string>

namespace sr::cli {

/// A bar that shows itself when the work has taken a second, and only on a terminal.
class Progress {
public:
    explicit Progress(std::string what);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// `share` of the work is done, 0 to 1; `state` says it in the work's own terms.
    void update(double share, const std::string& state);

private:
    using Clock = std::chrono::steady_clock;

    std::string what_;
    bool is_terminal_;
    bool is_shown_ = false;
    Clock::time_point begin_ = Clock::now();
    Clock::time_point last_ = begin_;
};

} // namespace sr::cli
