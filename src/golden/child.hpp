#pragma once
// A program that runs beside this one, for a limited time.
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace sr::golden {

struct ChildOptions {
    std::vector<std::string> words;   // the program (sought in PATH if it has no '/') and its arguments
    std::filesystem::path folder;     // where it runs
    std::filesystem::path log;        // gets what it writes to stdout and stderr
    double time_limit = 60.0;         // [s]
    std::function<bool()> is_stopped; // asked often; once true, the child is killed. Empty: never
};

struct ChildEnd {
    enum class Way { exited, signalled, timed_out, stopped, not_started };
    Way way = Way::exited;
    int status = 0; // exit status, signal number, or errno of not_started
    double seconds = 0.0;

    bool is_success() const { return way == Way::exited && status == 0; }
    /// "ended with exit status 3", "crashed: Segmentation fault (signal 11)", …
    std::string text() const;
};

/// Runs a program to its end, in a process group of its own, which is killed as a whole: SIGTERM, and SIGKILL
/// half a second later; also what a child leaves running when it ends. Any number of threads may call it.
ChildEnd run_child(const ChildOptions& options);

} // namespace sr::golden
