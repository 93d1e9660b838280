#pragma once
// A run of a suite: each image is made in a child process and compared with its golden.
#include "golden/result.hpp"

#include <functional>
#include <optional>
#include <stop_token>

namespace sr::golden {

struct RunOptions {
    std::filesystem::path program;    // what "{steradian}" in a command stands for
    std::filesystem::path output;     // folder for results, candidates and logs; made if it is not there
    int jobs = 1;                     // tests that run at the same time
    std::vector<std::string> filters; // only tests whose name matches one of these patterns; empty: all
    std::vector<std::string> tags;    // only tests with one of these tags; empty: all
    std::vector<std::string> shaders; // overlay folders, put before those of every scene test
    std::function<void(const TestResult&)>
        on_result;        // called in the suite's order, from one thread at a time
    std::stop_token stop; // kills the children and ends the run
};

/// Whether a pattern (* ? [a-z]) matches a name. A name always matches itself.
bool matches(const std::string& pattern, const std::string& name);

/// The words of a test's command. {steradian} is the program, {out} the image's name; the shaders of the
/// options come before those of the test.
std::vector<std::string> command_words(const GoldenTest& test, const RunOptions& options,
                                       std::string_view program, std::string_view out);

/// SHA-256 in hexadecimal of an image's size, channel names and pixels. Not of its file: an EXR holds the
/// time of its writing.
std::string fingerprint(const image::Image& image);

/// The tests that the filters and tags choose. @throws Error if there is none.
std::vector<GoldenTest> chosen_tests(const Suite& suite, const RunOptions& options);

/// Runs the chosen tests; a failing one does not end the others. Writes OUTPUT/candidates/NAME.exr and
/// OUTPUT/logs/NAME.txt. Removes the results of an earlier run first. @return absent if it was stopped.
/// @throws Error if the output folder cannot be written, or no test is chosen.
std::optional<RunResult> run(const Suite& suite, const RunOptions& options);

} // namespace sr::golden
