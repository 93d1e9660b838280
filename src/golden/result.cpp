#include "golden/result.hpp"

#include "core/error.hpp"
#include "core/file.hpp"
#include "image/whole_file.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>

namespace sr::golden {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

constexpr int format_version = 2;
constexpr std::array<std::string_view, 4> outcome_names{"passed", "differs", "missing", "broken"};

ordered_json json_of(const TestResult& test) {
    return {{"name", test.name},
            {"outcome", name_of(test.outcome)},
            {"message", test.message},
            {"description", test.description},
            {"tags", test.tags},
            {"fails_known_pixel", test.fails_known_pixel},
            {"candidate", test.candidate},
            {"candidate_sha256", test.candidate_sha256},
            {"golden", test.golden},
            {"alternate", test.alternate},
            {"candidate_renderer", test.candidate_renderer},
            {"golden_renderer", test.golden_renderer},
            {"command", test.command},
            {"comparison", test.comparison},
            {"log", test.log}};
}

TestResult test_of(const ordered_json& json) {
    TestResult test;
    const auto found = std::ranges::find(outcome_names, json.at("outcome").get<std::string>());
    test.outcome = static_cast<Outcome>(found - outcome_names.begin()); // an unknown one is caught below
    if (found == outcome_names.end()) throw Error(json.at("outcome").dump(), "no outcome of a test");
    json.at("name").get_to(test.name);
    json.at("message").get_to(test.message);
    json.at("description").get_to(test.description);
    json.at("tags").get_to(test.tags);
    json.at("fails_known_pixel").get_to(test.fails_known_pixel);
    json.at("candidate").get_to(test.candidate);
    json.at("candidate_sha256").get_to(test.candidate_sha256);
    json.at("golden").get_to(test.golden);
    json.at("alternate").get_to(test.alternate);
    json.at("candidate_renderer").get_to(test.candidate_renderer);
    json.at("golden_renderer").get_to(test.golden_renderer);
    json.at("command").get_to(test.command);
    json.at("log").get_to(test.log);
    test.comparison = json.at("comparison");
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

fs::path results_file(const fs::path& output) { return output / "results.json"; }
fs::path junit_file(const fs::path& output) { return output / "junit.xml"; }
fs::path report_file(const fs::path& output) { return output / "report.html"; }

void write_results(const RunResult& result, const fs::path& output) {
    ordered_json tests = ordered_json::array();
    for (const TestResult& test : result.tests) tests.push_back(json_of(test));
    const ordered_json json{{"steradian_golden_results", format_version},
                            {"suite", result.suite},
                            {"suite_file", result.suite_file},
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
        RunResult result{json.at("suite"), json.at("suite_file"), {}};
        for (const ordered_json& test : json.at("tests")) result.tests.push_back(test_of(test));
        return result;
    } catch (const std::exception&) {
        throw Error({file.string()}, "not the results of a run of this version",
                    "run steradian golden run again");
    }
}

} // namespace sr::golden
