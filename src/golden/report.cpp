#include "golden/report.hpp"

#include "golden/page.hpp"
#include "image/file.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace sr::golden {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

/// Failures first, in the suite's order within each kind.
std::vector<const TestResult*> failures_first(const RunResult& result) {
    std::vector<const TestResult*> tests;
    for (const TestResult& test : result.tests) tests.push_back(&test);
    const auto rank = [](const TestResult* test) {
        return test->outcome == Outcome::passed    ? 3
               : test->outcome == Outcome::missing ? 2
               : test->outcome == Outcome::broken  ? 1
                                                   : 0;
    };
    std::ranges::stable_sort(tests, {}, rank);
    return tests;
}

/// The commands that reproduce, rerun and approve a test, in the folder that the run was started in.
ordered_json commands_of(const TestResult& test, const RunResult& result, const Suite& suite,
                         const fs::path& output) {
    const std::string file = result.suite_file;
    ordered_json commands{
        {"reproduce", fmt::format("cd {} && {}", shell_line({suite.folder.string()}), test.command)},
        {"run again", shell_line({"steradian", "golden", "run", file, "--output", output.string(), "--filter",
                                  test.name})}};
    if (!test.candidate.empty() && test.outcome != Outcome::passed)
        commands["approve"] =
            shell_line({"steradian", "golden", "approve", file, test.name, "--output", output.string()});
    return commands;
}

/// The pictures of one test, as long as there is room for them.
class Pictures {
public:
    Pictures(const Suite& suite, const fs::path& output) : suite_(suite), output_(output) {}

    void add(ordered_json& json, const TestResult& test) {
        json["images_left_out"] = room_ == 0;
        json["is_display_referred"] = test.candidate.ends_with(".png");
        if (test.candidate.empty() || room_ == 0) return;
        json["test"] = pack_pixels(image::read(output_ / test.candidate));
        if (test.comparison.is_object()) {
            auto golden = pack_pixels(image::read(suite_.folder / test.golden));
            json["golden"] = golden == json["test"] ? ordered_json("equal") : std::move(golden);
        }
        for (const char* key : {"test", "golden"})
            if (json.contains(key) && json[key].is_object())
                room_ -= std::min(room_, json[key]["data"].get_ref<const std::string&>().size());
    }

private:
    const Suite& suite_;
    const fs::path& output_;
    std::size_t room_ = max_pixel_text;
};

ordered_json page_data(const RunResult& result, const Suite& suite, const fs::path& output) {
    ordered_json tests = ordered_json::array();
    Pictures pictures(suite, output);
    for (const TestResult* test : failures_first(result)) {
        ordered_json json{
            {"name", test->name},
            {"outcome", name_of(test->outcome)},
            {"message", test->message},
            {"description", test->description},
            {"tags", test->tags},
            {"renderer", {{"test", test->candidate_renderer}, {"golden", test->golden_renderer}}},
            {"commands", commands_of(*test, result, suite, output)},
            {"comparison", test->comparison},
            {"log", test->log}};
        pictures.add(json, *test);
        tests.push_back(std::move(json));
    }
    return {{"suite", result.suite},
            {"file", result.suite_file},
            {"version", STERADIAN_VERSION},
            {"tests", std::move(tests)}};
}

/// The table that shows where the script may not run.
std::string plain_table(const RunResult& result) {
    std::string rows;
    for (const TestResult* test : failures_first(result))
        rows += fmt::format("<tr><td>{}<td>{}<td>{}\n", name_of(test->outcome), escape_markup(test->name),
                            escape_markup(test->message));
    return "<table>\n<tr><th>outcome<th>test<th>what\n" + rows + "</table>\n";
}

} // namespace

std::string report_html(const RunResult& result, const Suite& suite, const fs::path& output) {
    std::string title =
        fmt::format("{}: {} of {} passed", result.suite, result.count(Outcome::passed), result.tests.size());
    if (const int n = result.passed_by_alternates()) title += fmt::format(" ({} as an alternate)", n);
    const std::string data =
        page_data(result, suite, output).dump(-1, ' ', false, ordered_json::error_handler_t::replace);
    return offline_page(title, plain_table(result), data, suite_page());
}

namespace {

std::string verdict_text(const TestResult& test) {
    std::string text = test.message + "\n";
    if (test.comparison.is_object()) {
        for (const auto& verdict : test.comparison.value("verdicts", nlohmann::ordered_json::array()))
            text += fmt::format("{} {}\n", verdict.value("passed", false) ? "ok    " : "FAILED",
                                verdict.value("line", ""));
    }
    return text + "command: " + test.command + "\n" + test.log;
}

std::string case_xml(const RunResult& result, const TestResult& test) {
    std::string xml = fmt::format("  <testcase classname=\"golden.{}\" name=\"{}\" time=\"{:.3f}\"",
                                  escape_markup(result.suite), escape_markup(test.name), test.seconds);
    if (test.outcome == Outcome::passed) return xml + "/>\n";
    const char* element = test.outcome == Outcome::broken ? "error" : "failure";
    return xml
           + fmt::format(">\n    <{0} type=\"{1}\" message=\"{2}\">{3}</{0}>\n  </testcase>\n", element,
                         name_of(test.outcome), escape_markup(test.message),
                         escape_markup(verdict_text(test)));
}

} // namespace

std::string junit_xml(const RunResult& result) {
    double seconds = 0.0;
    for (const TestResult& test : result.tests) seconds += test.seconds;
    const int errors = result.count(Outcome::broken);
    const int failures = result.count(Outcome::differs) + result.count(Outcome::missing);
    std::string xml = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
    xml += fmt::format("<testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"{}\" time=\"{:.3f}\">\n",
                       escape_markup(result.suite), result.tests.size(), failures, errors, seconds);
    for (const TestResult& test : result.tests) xml += case_xml(result, test);
    return xml + "</testsuite>\n";
}

} // namespace sr::golden
