#pragma once
// Results of a run, and the file results.json.
#include "golden/suite.hpp"

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace sr::golden {

enum class Outcome {
    passed,
    differs, // from its golden, or from a pixel known in closed form
    missing, // no golden to compare with
    broken   // no image: the command failed, hung or wrote none that can be read
};

std::string_view name_of(Outcome outcome);

struct TestResult {
    std::string name;
    std::string description;
    std::vector<std::string> tags;
    Outcome outcome = Outcome::broken;
    std::string message; // one line; empty for a test that passed
    bool fails_known_pixel = false;
    bool has_unreadable_file = false; // a candidate or golden that is no image; not kept in results.json
    std::string candidate;            // file in the output folder; empty if there is none
    std::string candidate_sha256;     // fingerprint of the candidate that was compared
    std::string golden;               // file, relative to the suite's folder
    std::string alternate; // label of the alternate that it agrees with in the golden's stead; mostly empty
    std::string candidate_renderer; // "GL_RENDERER, GL_VERSION" as its file says; empty if it does not
    std::string golden_renderer;
    std::string command;               // one line for a shell in the suite's folder
    nlohmann::ordered_json comparison; // json_of(Comparison); null if nothing was compared
    std::string log;                   // the end of what the command wrote
    double seconds = 0.0;              // not kept in results.json, which is the same for equal runs
};

struct RunResult {
    std::string suite;             // its name
    std::string suite_file;        // as given
    std::vector<TestResult> tests; // in the suite's order

    int count(Outcome outcome) const;
    int passed_by_alternates() const;
    bool passed() const { return count(Outcome::passed) == static_cast<int>(tests.size()); }
};

/// The files of an output folder.
std::filesystem::path results_file(const std::filesystem::path& output);
std::filesystem::path junit_file(const std::filesystem::path& output);
std::filesystem::path report_file(const std::filesystem::path& output);

/// Writes results.json whole or not at all. Equal runs give equal bytes. @throws Error.
void write_results(const RunResult& result, const std::filesystem::path& output);

/// @throws Error if the last run left none there, or it is not one of ours.
RunResult read_results(const std::filesystem::path& output);

} // namespace sr::golden
