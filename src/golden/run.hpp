#pragma once
// Runs a suite: makes each image in a child process of its own and compares it with its golden.
#include "golden/result.hpp"

#include <functional>
#include <optional>

namespace sr::golden {

struct RunOptions {
    std::filesystem::path program; // what "{steradian}" in a command stands for
    std::filesystem::path output;  // folder for results, candidates and logs; made if it is not there
    int jobs = 1;                  // tests that run at the same time
    std::vector<std::string>
        filters;                   // only tests whose name fits one of these patterns (* ? [a-z]); empty: all
    std::vector<std::string> tags; // only tests with one of these tags; empty: all
    std::vector<std::string> shaders; // overlay folders, put before those of every scene test
    std::function<void(const TestResult&)>
        on_result;                        // called in the suite's order, from one thread at a time
    std::function<bool()> is_interrupted; // asked often; once true, children are killed
};

/// Whether a test is meant by a pattern (* ? [a-z]); its own name, whatever is in it, always means it.
bool is_meant(const std::string& pattern, const std::string& name);

/// The tests that the filters and tags leave. @throws Error if none is left.
std::vector<GoldenTest> chosen_tests(const Suite& suite, const RunOptions& options);

/// Runs the chosen tests; a failing one never ends the others. Leaves OUTPUT/candidates/NAME.exr and
/// OUTPUT/logs/NAME.txt, and removes the results of an earlier run at once, so that nothing of it can be
/// taken for this one's. @return absent if it was interrupted.
/// @throws Error if the output folder cannot be written, or no test is chosen.
std::optional<RunResult> run(const Suite& suite, const RunOptions& options);

} // namespace sr::golden
