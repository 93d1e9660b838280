#include "golden/junit.hpp"

#include "golden/escape.hpp"

#include <fmt/format.h>

namespace sr::golden {
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
                                  escaped_markup(result.suite), escaped_markup(test.name), test.seconds);
    if (test.outcome == Outcome::passed) return xml + "/>\n";
    const char* element = test.outcome == Outcome::broken ? "error" : "failure";
    return xml
           + fmt::format(">\n    <{0} type=\"{1}\" message=\"{2}\">{3}</{0}>\n  </testcase>\n", element,
                         name_of(test.outcome), escaped_markup(test.message),
                         escaped_markup(verdict_text(test)));
}

} // namespace

std::string junit_xml(const RunResult& result) {
    double seconds = 0.0;
    for (const TestResult& test : result.tests) seconds += test.seconds;
    const int errors = result.count(Outcome::broken);
    const int failures = result.count(Outcome::differs) + result.count(Outcome::missing);
    std::string xml = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
    xml += fmt::format("<testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"{}\" time=\"{:.3f}\">\n",
                       escaped_markup(result.suite), result.tests.size(), failures, errors, seconds);
    for (const TestResult& test : result.tests) xml += case_xml(result, test);
    return xml + "</testsuite>\n";
}

} // namespace sr::golden
