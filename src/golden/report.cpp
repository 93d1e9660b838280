#include "golden/report.hpp"

#include "compare/compare.hpp"
#include "core/error.hpp"
#include "core/markup.hpp"
#include "core/text.hpp"
#include "golden/page.hpp"
#include "golden/run.hpp"
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
        switch (test->outcome) {
        case Outcome::differs: return 0;
        case Outcome::unreadable: return 1;
        case Outcome::broken: return 2;
        case Outcome::missing: return 3;
        case Outcome::flaky: return 4;
        default: return 5;
        }
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
    const bool is_good = test.outcome == Outcome::passed || test.outcome == Outcome::flaky;
    if (!test.candidate.empty() && !is_good && !test.is_earlier)
        commands["approve"] =
            shell_line({"steradian", "golden", "approve", file, test.name, "--output", output.string()});
    return commands;
}

/// The pictures of one test, as long as there is room for them.
class Pictures {
public:
    Pictures(const Suite& suite, const fs::path& output) : suite_(suite), output_(output) {}

    /// Adds {"test", "golden", "errors"}: of a test that differs, the errors of its pixels over their limits.
    /// A picture that is not the one that the run compared is left out, and "images_problem" says so.
    void add(ordered_json& json, const TestResult& test) {
        json["images_left_out"] = room_ == 0;
        json["is_display_referred"] = false;
        if (test.candidate.empty() || room_ == 0) return;
        try {
            add_images(json, test);
        } catch (const std::exception& error) { // files may have changed or vanished since the run
            json["images_problem"] = error.what();
        }
        for (const char* key : {"test", "golden", "errors"})
            if (json.contains(key) && json[key].is_object())
                room_ -= std::min(room_, json[key]["data"].get_ref<const std::string&>().size());
    }

private:
    /// @throws Error if it is another picture than the run compared, or none
    static image::Image compared(const fs::path& file, const std::string& sha256) {
        image::Image image = image::read(file);
        if (!sha256.empty() && fingerprint(image) != sha256)
            throw Error({file.string()}, "the picture has changed since the run", "run the test again");
        return image;
    }

    void add_images(ordered_json& json, const TestResult& test) const {
        const image::Image candidate = compared(output_ / test.candidate, test.candidate_sha256);
        json["is_display_referred"] = compare::integer_bits(candidate) > 0;
        json["test"] = pack_pixels(candidate);
        if (!test.comparison.is_object()) return;
        const image::Image golden = compared(suite_.folder / test.golden, test.golden_sha256);
        ordered_json packed = pack_pixels(golden);
        json["golden"] = packed == json["test"] ? ordered_json("equal") : std::move(packed);
        if (test.outcome == Outcome::differs) add_errors(json, test.name, candidate, golden);
    }

    void add_errors(ordered_json& json, const std::string& name, const image::Image& candidate,
                    const image::Image& golden) const {
        const auto test = std::ranges::find(suite_.tests, name, &GoldenTest::name);
        if (test == suite_.tests.end()) return;
        compare::Comparison comparison =
            compare::compare(candidate, golden, compare_options(*test, candidate, golden));
        constexpr float max_error = 1000.0f; // a page of half floats shows the limit and this at once
        for (float& error : comparison.error.pixels)
            error = error > max_error ? max_error : error; // NaN stays
        const bool is_whole =
            comparison.error.width == golden.width && comparison.error.height == golden.height;
        if (is_whole && !comparison.error.pixels.empty()) json["errors"] = pack_pixels(comparison.error);
    }

    const Suite& suite_;
    const fs::path& output_;
    std::size_t room_ = max_pixel_text;
};

ordered_json json_of(const RunRecord& record) {
    return {{"began", record.began},   {"host", record.host}, {"commit", record.commit},
            {"branch", record.branch}, {"link", record.link}, {"seconds", record.total_seconds()}};
}

ordered_json orphans_json(const Suite& suite) {
    ordered_json orphans = ordered_json::array();
    for (const fs::path& orphan : orphans_of(suite)) orphans.push_back(orphan.generic_string());
    return orphans;
}

ordered_json page_data(const RunResult& result, const Suite& suite, const fs::path& output) {
    ordered_json tests = ordered_json::array();
    const std::optional<RunRecord> record = read_record(output);
    Pictures pictures(suite, output);
    for (const TestResult* test : failures_first(result)) {
        ordered_json json{
            {"name", test->name},
            {"outcome", name_of(test->outcome)},
            {"message", test->message},
            {"description", test->description},
            {"tags", test->tags},
            {"candidate_sha256", test->candidate_sha256},
            {"largest_error_over_limit", test->largest_error},
            {"is_earlier", test->is_earlier},
            {"attempts", ordered_json::array()},
            {"renderer", {{"test", test->candidate_renderer}, {"golden", test->golden_renderer}}},
            {"commands", commands_of(*test, result, suite, output)},
            {"comparison", test->comparison},
            {"log", test->log}};
        for (const Attempt& attempt : test->attempts)
            json["attempts"].push_back(fmt::format("{}: {}", name_of(attempt.outcome), attempt.message));
        if (record)
            if (const auto seconds = record->seconds.find(test->name); seconds != record->seconds.end())
                json["seconds"] = seconds->second;
        pictures.add(json, *test);
        tests.push_back(std::move(json));
    }
    return {{"suite", result.suite},
            {"file", result.suite_file},
            {"version", STERADIAN_VERSION},
            {"run", record ? json_of(*record) : ordered_json()},
            {"orphans", orphans_json(suite)},
            {"approve", shell_line({"steradian", "golden", "approve", result.suite_file, "--output",
                                    output.string(), "--failed-as-reviewed"})},
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

bool is_error(Outcome outcome) { return outcome == Outcome::broken || outcome == Outcome::unreadable; }

std::string case_xml(const RunResult& result, const TestResult& test) {
    std::string xml = fmt::format("  <testcase classname=\"golden.{}\" name=\"{}\" time=\"{:.3f}\"",
                                  escape_markup(result.suite), escape_markup(test.name), test.seconds);
    if (test.outcome == Outcome::passed) return xml + "/>\n";
    xml += ">\n";
    if (test.outcome != Outcome::flaky)
        xml += fmt::format("    <{0} type=\"{1}\" message=\"{2}\">{3}</{0}>\n",
                           is_error(test.outcome) ? "error" : "failure", name_of(test.outcome),
                           escape_markup(test.message), escape_markup(verdict_text(test)));
    const char* element = test.outcome == Outcome::flaky ? "flakyFailure" : "rerunFailure";
    for (const Attempt& attempt : test.attempts)
        xml += fmt::format("    <{} type=\"{}\" message=\"{}\"/>\n", element, name_of(attempt.outcome),
                           escape_markup(attempt.message));
    return xml + "  </testcase>\n";
}

} // namespace

std::string junit_xml(const RunResult& result) {
    double seconds = 0.0;
    for (const TestResult& test : result.tests) seconds += test.seconds;
    const int errors = result.count(Outcome::broken) + result.count(Outcome::unreadable);
    const int failures = result.count(Outcome::differs) + result.count(Outcome::missing);
    std::string xml = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
    xml += fmt::format("<testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"{}\" time=\"{:.3f}\">\n",
                       escape_markup(result.suite), result.tests.size(), failures, errors, seconds);
    for (const TestResult& test : result.tests) xml += case_xml(result, test);
    return xml + "</testsuite>\n";
}

std::string count_text(const RunResult& result) {
    std::string text = fmt::format("{} of {} passed", result.count(Outcome::passed), result.tests.size());
    if (const int n = result.passed_by_alternates()) text += fmt::format(" ({} as an alternate)", n);
    if (const int n = result.count(Outcome::differs))
        text += fmt::format(", {} {}", n, n == 1 ? "differs" : "differ");
    if (const int n = result.count(Outcome::missing)) text += fmt::format(", {} without a golden", n);
    if (const int n = result.count(Outcome::broken)) text += fmt::format(", {} broken", n);
    if (const int n = result.count(Outcome::unreadable)) text += fmt::format(", {} unreadable", n);
    if (const int n = result.count(Outcome::flaky)) text += fmt::format(", {} flaky", n);
    return text;
}

namespace {

/// Text as Markdown shows it in a cell of a table.
std::string cell(std::string_view text) {
    std::string result;
    for (const char c : escape_markup(text)) {
        if (c == '\n' || c == '\r') {
            result += ' ';
            continue;
        }
        if (std::string_view("\\|`*_[]~").find(c) != std::string_view::npos) result += '\\';
        result += c;
    }
    return result;
}

} // namespace

std::string summary_markdown(const RunResult& result, const std::optional<RunRecord>& record) {
    constexpr std::size_t max_size = 60000, max_message = 300;
    std::string text = fmt::format("### Golden images of {}: {}\n\n", cell(result.suite), count_text(result));
    if (record && !record->commit.empty())
        text +=
            fmt::format("Commit {}, {:.1f} s.{}\n\n", record->commit.substr(0, 12), record->total_seconds(),
                        record->link.empty() ? "" : fmt::format(" [Job]({})", record->link));
    const auto tests = failures_first(result);
    if (result.passed()) return text;
    text += "| outcome | test | what |\n|---|---|---|\n";
    for (std::size_t i = 0; i < tests.size() && tests[i]->outcome != Outcome::passed; ++i) {
        if (text.size() > max_size - 2000) return text + "\n… and further tests: see the report.\n";
        text += fmt::format("| {} | {} | {} |\n", name_of(tests[i]->outcome), cell(tests[i]->name),
                            cell(shorten(tests[i]->message, max_message)));
    }
    return text;
}

} // namespace sr::golden
