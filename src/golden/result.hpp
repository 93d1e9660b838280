#pragma once
// Results of a run, and the file results.json.
#include "golden/suite.hpp"

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace sr::golden {

enum class Outcome {
    passed,
    differs,   // from its golden, or from a pixel known in closed form
    missing,   // no golden to compare with
    broken,    // no image: the command failed, hung or wrote none
    flaky,     // it passed, but only when it was tried again
    unreadable // its candidate, its golden or another file of it is no image that can be read
};

std::string_view name_of(Outcome outcome);

/// An attempt that failed before the last one.
struct Attempt {
    Outcome outcome = Outcome::broken;
    std::string message;
    std::string candidate; // file in the output folder; empty if there is none
};

struct TestResult {
    std::string name;
    std::string description;
    std::vector<std::string> tags;
    Outcome outcome = Outcome::broken;
    std::string message; // one line; empty for a test that passed
    bool fails_known_pixel = false;
    std::string candidate;        // file in the output folder; empty if there is none
    std::string candidate_sha256; // fingerprint of the candidate that was compared
    std::string golden;           // file, relative to the suite's folder
    std::string golden_sha256;    // fingerprint of the golden that it was compared with
    std::string alternate; // label of the alternate that it agrees with in the golden's stead; mostly empty
    std::string candidate_renderer; // "GL_RENDERER, GL_VERSION" as its file says; empty if it does not
    std::string golden_renderer;
    std::string command;        // one line for a shell in the suite's folder
    double largest_error = 0.0; // of a pixel, over its limit: 1 is at the limit; a forgiven one is above
    nlohmann::ordered_json comparison; // json_of(Comparison); null if nothing was compared
    std::string log;                   // the end of what the command wrote
    std::vector<Attempt> attempts;     // that failed before it was tried again
    bool is_earlier = false;           // an earlier run's: this one left the test out
    double seconds = 0.0;              // not kept in results.json, which is the same for equal runs
};

struct RunResult {
    std::string suite;             // its name
    std::string suite_file;        // as given
    std::vector<TestResult> tests; // in the suite's order
    std::string suite_sha256{};    // of the suite's file
    /// The suite's file as seen from the output folder; set by read_results().
    std::filesystem::path suite_from_output{};

    int count(Outcome outcome) const;
    int passed_by_alternates() const;
    bool passed() const { return count(Outcome::passed) == static_cast<int>(tests.size()); }
    /// Without the results that are an earlier run's.
    RunResult of_this_run() const;
};

/// The results of a run of this suite.
RunResult result_of(const Suite& suite, std::vector<TestResult> tests);

/// True if the results in an output folder are of this suite: of its file, or, where the folder was moved, of
/// one with the same text.
bool are_of(const RunResult& result, const std::filesystem::path& output, const Suite& suite);

/// Time and place of a run, in the file run.json: all that differs between equal runs. A text is empty where
/// it is unknown.
struct RunRecord {
    std::string began; // UTC, as 2024-02-29T12:00:00Z
    std::string host;
    std::string commit;
    std::string branch;
    std::string link;                      // to the job of a CI system; begins with http:// or https://
    std::map<std::string, double> seconds; // by test

    double total_seconds() const;
};

/// The files of an output folder.
std::filesystem::path results_file(const std::filesystem::path& output);
std::filesystem::path junit_file(const std::filesystem::path& output);
std::filesystem::path report_file(const std::filesystem::path& output);
std::filesystem::path summary_file(const std::filesystem::path& output);
std::filesystem::path record_file(const std::filesystem::path& output);

/// Writes results.json whole or not at all. Equal runs give equal bytes. @throws Error.
void write_results(const RunResult& result, const std::filesystem::path& output);

/// @throws Error if the last run left none there, or it is not one of ours.
RunResult read_results(const std::filesystem::path& output);

/// Describes a run that begins now in `folder`: the host, and the commit as the variables of GitHub, GitLab
/// and Jenkins or else Git have it.
RunRecord begun_record(const std::filesystem::path& folder, const std::filesystem::path& output);

/// @throws Error.
void write_record(const RunRecord& record, const std::filesystem::path& output);

/// The durations of tests in a file as write_record() leaves it. @throws Error if there are none.
std::map<std::string, double> read_durations(const std::filesystem::path& file);

/// Absent if there is none that can be read.
std::optional<RunRecord> read_record(const std::filesystem::path& output);

} // namespace sr::golden
