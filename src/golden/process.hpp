#pragma once
// Child processes with a time limit.
#include <filesystem>
#include <functional>
#include <stop_token>
#include <string>
#include <vector>

namespace sr::golden {

struct ProcessOptions {
    std::vector<std::string> words;        // the program (sought in PATH if it has no '/') and its arguments
    std::filesystem::path folder;          // working directory
    std::filesystem::path log;             // receives stdout and stderr
    double time_limit = 60.0;              // [s]
    std::stop_token stop{};                // kills the process
    std::function<void()> while_running{}; // called every few milliseconds; may request the stop
};

struct ProcessEnd {
    enum class Way { exited, signalled, timed_out, stopped, not_started };
    Way way = Way::exited;
    int status = 0; // exit status, signal number, or errno of not_started
    double seconds = 0.0;

    bool is_success() const { return way == Way::exited && status == 0; }
    /// "ended with exit status 3", "crashed: Segmentation fault (signal 11)", …
    std::string text() const;
};

/// Runs a program to its end, in a process group of its own. The group is killed as a whole: at a stop or at
/// the time limit by SIGTERM, and SIGKILL half a second later; and when the program ends, with whatever it
/// leaves running. Any number of threads may call it.
ProcessEnd run_process(const ProcessOptions& options);

} // namespace sr::golden
