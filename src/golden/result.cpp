#include "golden/result.hpp"

#include "core/error.hpp"
#include "core/file.hpp"
#include "golden/process.hpp"
#include "image/whole_file.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <functional>
#include <sstream>
#include <unistd.h>

namespace sr::golden {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

constexpr int format_version = 4;
constexpr std::array<std::string_view, 6> outcome_names{"passed", "differs", "missing",
                                                        "broken", "flaky",   "unreadable"};

Outcome outcome_of(const ordered_json& json) {
    const auto found = std::ranges::find(outcome_names, json.get<std::string>());
    if (found == outcome_names.end()) throw Error(json.dump(), "no outcome of a test");
    return static_cast<Outcome>(found - outcome_names.begin());
}

ordered_json json_of(const TestResult& test) {
    ordered_json attempts = ordered_json::array();
    for (const Attempt& attempt : test.attempts)
        attempts.push_back({{"outcome", name_of(attempt.outcome)},
                            {"message", attempt.message},
                            {"candidate", attempt.candidate}});
    return {{"name", test.name},
            {"outcome", name_of(test.outcome)},
            {"message", test.message},
            {"description", test.description},
            {"tags", test.tags},
            {"fails_known_pixel", test.fails_known_pixel},
            {"candidate", test.candidate},
            {"candidate_sha256", test.candidate_sha256},
            {"golden", test.golden},
            {"golden_sha256", test.golden_sha256},
            {"alternate", test.alternate},
            {"candidate_renderer", test.candidate_renderer},
            {"golden_renderer", test.golden_renderer},
            {"command", test.command},
            {"largest_error_over_limit", test.largest_error},
            {"comparison", test.comparison},
            {"log", test.log},
            {"attempts", std::move(attempts)},
            {"is_earlier", test.is_earlier}};
}

TestResult test_of(const ordered_json& json) {
    TestResult test;
    test.outcome = outcome_of(json.at("outcome"));
    json.at("name").get_to(test.name);
    json.at("message").get_to(test.message);
    json.at("description").get_to(test.description);
    json.at("tags").get_to(test.tags);
    json.at("fails_known_pixel").get_to(test.fails_known_pixel);
    json.at("candidate").get_to(test.candidate);
    json.at("candidate_sha256").get_to(test.candidate_sha256);
    json.at("golden").get_to(test.golden);
    json.at("golden_sha256").get_to(test.golden_sha256);
    json.at("alternate").get_to(test.alternate);
    json.at("candidate_renderer").get_to(test.candidate_renderer);
    json.at("golden_renderer").get_to(test.golden_renderer);
    json.at("command").get_to(test.command);
    json.at("log").get_to(test.log);
    json.at("largest_error_over_limit").get_to(test.largest_error);
    test.comparison = json.at("comparison");
    for (const ordered_json& attempt : json.at("attempts"))
        test.attempts.push_back(
            {outcome_of(attempt.at("outcome")), attempt.at("message"), attempt.at("candidate")});
    json.at("is_earlier").get_to(test.is_earlier);
    return test;
}

} // namespace

std::string_view name_of(Outcome outcome) { return outcome_names[static_cast<std::size_t>(outcome)]; }

int RunResult::count(Outcome outcome) const {
    return static_cast<int>(std::ranges::count(tests, outcome, &TestResult::outcome));
}

int RunResult::passed_by_alternates() const {
    return static_cast<int>(std::ranges::count_if(tests, [](const TestResult& test) {
        return test.outcome == Outcome::passed && !test.alternate.empty();
    }));
}

RunResult RunResult::of_this_run() const {
    RunResult result = *this;
    std::erase_if(result.tests, std::mem_fn(&TestResult::is_earlier));
    return result;
}

RunResult result_of(const Suite& suite, std::vector<TestResult> tests) {
    return {suite.name, suite.file.string(), std::move(tests), suite.sha256, {}};
}

bool are_of(const RunResult& result, const fs::path& output, const Suite& suite) {
    if (result.suite != suite.name) return false;
    std::error_code ignored;
    const fs::path file = output / result.suite_from_output;
    if (fs::exists(file, ignored)) return fs::equivalent(file, suite.file, ignored);
    return result.suite_sha256 == suite.sha256; // the output folder was moved, or comes from another machine
}

double RunRecord::total_seconds() const {
    double sum = 0.0;
    for (const auto& [test, duration] : seconds) sum += duration;
    return sum;
}

fs::path results_file(const fs::path& output) { return output / "results.json"; }
fs::path junit_file(const fs::path& output) { return output / "junit.xml"; }
fs::path report_file(const fs::path& output) { return output / "report.html"; }
fs::path summary_file(const fs::path& output) { return output / "summary.md"; }
fs::path record_file(const fs::path& output) { return output / "run.json"; }

void write_results(const RunResult& result, const fs::path& output) {
    ordered_json tests = ordered_json::array();
    for (const TestResult& test : result.tests) tests.push_back(json_of(test));
    const ordered_json json{
        {"steradian_golden_results", format_version},
        {"suite", result.suite},
        {"suite_file", result.suite_file},
        {"suite_from_output", fs::absolute(result.suite_file)
                                  .lexically_normal()
                                  .lexically_relative(fs::absolute(output).lexically_normal())
                                  .generic_string()},
        {"suite_sha256", result.suite_sha256},
        {"passed", result.passed()},
        {"tests", std::move(tests)}};
    // A log or an attribute may hold any bytes.
    image::write_text(results_file(output),
                      json.dump(1, ' ', false, ordered_json::error_handler_t::replace) + "\n");
}

RunResult read_results(const fs::path& output) {
    const fs::path file = results_file(output);
    std::error_code ignored;
    if (!fs::exists(file, ignored))
        throw Error({file.string()}, "no results of a run", "run steradian golden run first, to its end");
    try {
        const auto json = ordered_json::parse(read_text(file));
        if (json.at("steradian_golden_results") != format_version) throw Error("another version", "");
        RunResult result{json.at("suite"), json.at("suite_file"), {}, json.at("suite_sha256"), {}};
        result.suite_from_output = json.at("suite_from_output").get<std::string>();
        for (const ordered_json& test : json.at("tests")) result.tests.push_back(test_of(test));
        return result;
    } catch (const std::exception&) {
        throw Error({file.string()}, "not the results of a run of this version",
                    "run steradian golden run again");
    }
}

namespace {

/// The value of the first of these environment variables that is set.
std::string environment(std::initializer_list<const char*> names) {
    for (const char* name : names)
        if (const char* value = std::getenv(name); value != nullptr && *value != '\0') return value;
    return {};
}

std::string host_name() {
    std::array<char, 256> name{};
    return gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "";
}

/// True for the name of a commit: 40 or 64 hexadecimal digits.
bool is_commit(std::string_view text) {
    return (text.size() == 40 || text.size() == 64)
           && text.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

/// The commit that Git has checked out in a folder; empty if there is none.
std::string git_commit(const fs::path& folder, const fs::path& scratch) {
    ProcessOptions git{{"git", "rev-parse", "HEAD"}, fs::absolute(folder), fs::absolute(scratch), 5.0};
    const std::string text = run_process(git).is_success() ? read_text(scratch) : "";
    std::error_code ignored;
    fs::remove(scratch, ignored);
    std::istringstream lines(text); // warnings of Git may stand before it
    for (std::string line; std::getline(lines, line);)
        if (is_commit(line)) return line;
    return {};
}

std::string job_link() {
    const std::string github = environment({"GITHUB_RUN_ID"});
    std::string link = github.empty()
                           ? environment({"CI_JOB_URL", "BUILD_URL"})
                           : fmt::format("{}/{}/actions/runs/{}", environment({"GITHUB_SERVER_URL"}),
                                         environment({"GITHUB_REPOSITORY"}), github);
    return link.starts_with("http://") || link.starts_with("https://") ? link : "";
}

} // namespace

RunRecord begun_record(const fs::path& folder, const fs::path& output) {
    RunRecord record;
    const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
    record.began = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(now));
    record.host = host_name();
    record.commit = environment({"GITHUB_SHA", "CI_COMMIT_SHA", "GIT_COMMIT"});
    std::error_code ignored;
    fs::create_directories(output, ignored);
    if (record.commit.empty()) record.commit = git_commit(folder, output / ".commit");
    record.branch = environment({"GITHUB_HEAD_REF", "GITHUB_REF_NAME", "CI_COMMIT_REF_NAME", "BRANCH_NAME"});
    record.link = job_link();
    return record;
}

void write_record(const RunRecord& record, const fs::path& output) {
    const ordered_json json{{"steradian_golden_run", 1}, {"began", record.began},   {"host", record.host},
                            {"commit", record.commit},   {"branch", record.branch}, {"link", record.link},
                            {"seconds", record.seconds}};
    image::write_text(record_file(output),
                      json.dump(1, ' ', false, ordered_json::error_handler_t::replace) + "\n");
}

std::map<std::string, double> read_durations(const fs::path& file) {
    const std::string text = read_text(file);
    try {
        std::map<std::string, double> seconds = ordered_json::parse(text).at("seconds");
        if (!seconds.empty()) return seconds;
    } catch (const std::exception&) { // the error below says it
    }
    throw Error({file.string()}, "no durations of tests", "name the run.json of an earlier run");
}

std::optional<RunRecord> read_record(const fs::path& output) {
    std::error_code ignored;
    if (!fs::exists(record_file(output), ignored)) return std::nullopt;
    try {
        const auto json = ordered_json::parse(read_text(record_file(output)));
        RunRecord record{json.at("began"),  json.at("host"), json.at("commit"),
                         json.at("branch"), json.at("link"), json.at("seconds")};
        if (!record.link.starts_with("http://") && !record.link.starts_with("https://")) record.link.clear();
        return record;
    } catch (const std::exception&) { // times are worth having, and no reason to fail
        return std::nullopt;
    }
}

} // namespace sr::golden
