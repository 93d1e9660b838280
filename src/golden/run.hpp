#pragma once
// A run of a suite: each image is made in a child process and compared with its golden.
#include "golden/result.hpp"

#include <functional>
#include <optional>
#include <stop_token>

namespace sr::golden {

/// One of several parts of a suite, which run on different machines.
struct Shard {
    int index = 1; // from 1
    int count = 1;

    friend bool operator==(const Shard&, const Shard&) = default;
};

/// Parses "2/8". Absent for another text, and for a part that there is not.
std::optional<Shard> parsed_shard(std::string_view text);

struct RunOptions {
    std::filesystem::path program;         // what "{steradian}" in a command stands for
    std::filesystem::path output;          // folder for results, candidates and logs; made if it is not there
    int jobs = 1;                          // tests that run at the same time
    int retries = 0;                       // further attempts of a test that differs or makes no image
    std::optional<Shard> shard;            // only this part of the tests; absent: all
    std::map<std::string, double> seconds; // durations of tests, by which shards are balanced; may be empty
    std::vector<std::string> filters;      // only tests whose name matches one of these patterns; empty: all
    std::vector<std::string> tags;         // only tests with one of these tags; empty: all
    std::vector<std::string> shaders;      // overlay folders, put before those of every scene test
    std::function<void(const TestResult&)>
        on_result;        // called in the suite's order, from one thread at a time
    std::stop_token stop; // kills the children and ends the run
};

/// Whether a pattern (* ? [a-z]) matches a name. A name always matches itself.
bool matches(const std::string& pattern, const std::string& name);

/// The seed of a run, which no noise image uses: those begin at 1.
inline constexpr std::string_view seed_of_runs = "0";

/// The words of a test's command. {steradian} is the program, {out} the image's name, {seed} the seed of an
/// external command; the shaders of the options come before those of the test.
std::vector<std::string> command_words(const GoldenTest& test, const RunOptions& options,
                                       std::string_view program, std::string_view out,
                                       std::string_view seed = seed_of_runs);

/// Returns who rendered a picture: GL_RENDERER and GL_VERSION as its attributes have them, or else the
/// renderer and the version of the file beside it, as "RENDERER, VERSION". Empty if neither says so.
/// @throws Error for a file beside it that is not as sidecar_of() has it.
std::string renderer_of(const image::Image& image, const std::filesystem::path& file);

/// The same by the attributes alone.
std::string renderer_of(const image::Image& image);

/// SHA-256 in hexadecimal of an image's size, channel names and pixels. Not of its file: an EXR holds the
/// time of its writing.
std::string fingerprint(const image::Image& image);

/// How a test's candidate is compared with its golden. @throws Error if its mask or noise cannot be read.
compare::CompareOptions compare_options(const GoldenTest& test, const image::Image& candidate,
                                        const image::Image& reference);

/// The tests that the filters and tags choose, and of these the shard's: each test is in one shard. With
/// durations, each test in turn, the longest first, goes to the shard that has the least to do.
/// @throws Error if the filters and tags choose none. A shard may be empty.
std::vector<GoldenTest> chosen_tests(const Suite& suite, const RunOptions& options);

/// Makes the folders of an output folder and removes the results of an earlier run. @throws Error
void prepare_output(const std::filesystem::path& output);

/// Runs the chosen tests; a failing one does not end the others. Writes OUTPUT/candidates/NAME.exr,
/// OUTPUT/logs/NAME.txt and, for attempts that failed before, OUTPUT/attempts/NAME.1.exr. Removes the results
/// of an earlier run first; where filters or tags choose, those of the same suite's other tests are kept and
/// marked.
/// @return absent if it was stopped.
/// @throws Error if the output folder cannot be written, or no test is chosen.
std::optional<RunResult> run(const Suite& suite, const RunOptions& options);

} // namespace sr::golden
