#include "assignment/class_report.hpp"

#include "core/text.hpp"
#include "golden/page.hpp"
#include "image/display.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string_view>
#include <utility>

namespace sr::assignment {
namespace {

using golden::escape_markup;
using nlohmann::ordered_json;

std::string word(const ordered_json& object, const char* key) { return object.value(key, ""); }
double number(const ordered_json& object, const char* key) { return object.value(key, 0.0); }

std::string cell(const std::string& text) {
    std::string value = shown(text);
    std::ranges::replace(value, ';', ','); // where it separates cells, quotes within a line do not count
    // The wide forms of = + - @ count where Chinese or Japanese is written.
    const bool is_wide = std::ranges::any_of(std::array{"＝", "＋", "－", "＠"},
                                             [&](const char* sign) { return value.starts_with(sign); });
    if (is_wide || (!value.empty() && std::string_view("=+-@|%").find(value[0]) != std::string_view::npos))
        value.insert(0, "'");
    for (std::size_t at = 0; (at = value.find('"', at)) != std::string::npos; at += 2) value.insert(at, "\"");
    return '"' + value + '"';
}

/// Lists what a person should look at.
std::vector<std::string> remarks_of(const ordered_json& result) {
    std::vector<std::string> remarks;
    for (const ordered_json& line : result.value("refused", ordered_json::array())) remarks.push_back(line);
    if (const std::string label = word(result, "label");
        !label.empty() && label != word(result, "assignment"))
        remarks.push_back(fmt::format("its label says {}", shown(label)));
    const std::string student = word(result, "student"), named = word(result, "label_student");
    if (!named.empty() && named != student)
        remarks.push_back(fmt::format("{} handed in the folder of {}", shown(student), shown(named)));
    if (const auto others = result.value("same_student", std::vector<std::string>{}); !others.empty())
        remarks.push_back(fmt::format("{}{} of the same student, {}", others[0],
                                      others.size() > 1 ? fmt::format(" and {} more", others.size() - 1) : "",
                                      shown(student)));
    return remarks;
}

/// The lines on a task for its student.
std::string explanation(const ordered_json& task) {
    std::vector<std::string> lines;
    for (const ordered_json& problem : task["problems"]) {
        const int line = problem.value("line", 0);
        lines.push_back((line > 0 ? fmt::format("{}:{}: ", word(problem, "file"), line) : "")
                        + word(problem, "text"));
        if (const std::string hint = word(problem, "hint"); !hint.empty()) lines.push_back(hint);
    }
    for (const ordered_json& check : task["checks"]) {
        if (check["passed"].get<bool>()) continue;
        lines.push_back(fmt::format("{}: {}", word(check, "name"), word(check, "message")));
        if (!word(check, "got").empty())
            lines.push_back(fmt::format("got {}, expected {} {}, at {}", word(check, "got"),
                                        word(check, "expected"), word(check, "unit"), word(check, "at")));
        if (!check["diagnosis"].is_null()) lines.push_back(word(check["diagnosis"], "text"));
        if (const std::string hint = word(check, "hint");
            !hint.empty() && (lines.empty() || lines.back() != hint))
            lines.push_back(hint);
    }
    if (lines.empty() && word(task, "status") == "not implemented") lines.emplace_back("not implemented");
    return shown_lines(fmt::format("{}", fmt::join(lines, "\n")));
}

std::string heading(const ordered_json& task) { return word(task, "id") + " " + word(task, "title"); }

} // namespace

std::string csv_of(const std::vector<ordered_json>& results) {
    std::string text = "key,name,id,student,points,of,percent";
    if (!results.empty())
        for (const ordered_json& task : results[0]["tasks"]) text += "," + cell(word(task, "id"));
    text += ",remarks\r\n";
    for (const ordered_json& result : results) {
        text +=
            fmt::format("{},{},{},{},{:g},{:g},{:.1f}", cell(word(result, "key")), cell(word(result, "name")),
                        cell(word(result, "id")), cell(word(result, "student")), number(result, "points"),
                        number(result, "of"), number(result, "percent"));
        for (const ordered_json& task : result["tasks"]) text += fmt::format(",{:g}", number(task, "points"));
        text += fmt::format(",{}\r\n", cell(fmt::format("{}", fmt::join(remarks_of(result), "; "))));
    }
    return text;
}

std::string junit_of(const std::vector<ordered_json>& results) {
    std::string suites;
    std::size_t tests = 0, failures = 0;
    for (const ordered_json& result : results) {
        std::string cases;
        std::size_t failed = 0;
        for (const ordered_json& task : result["tasks"]) {
            const bool passed = word(task, "status") == "passed";
            cases += fmt::format("    <testcase classname=\"{}\" name=\"{}\"",
                                 escape_markup(word(result, "assignment")), escape_markup(heading(task)));
            if (passed || task.value("extra", false)) {
                cases += "/>\n";
                continue;
            }
            ++failed;
            cases += fmt::format(
                ">\n      <failure message=\"{:g} of {:g} points, {}\">{}</failure>\n    </testcase>\n",
                number(task, "points"), number(task, "of"), escape_markup(word(task, "status")),
                escape_markup(explanation(task)));
        }
        const std::string name = result.contains("name") ? word(result, "name") : word(result, "student");
        suites += fmt::format("  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\">\n{}  </testsuite>\n",
                              escape_markup(name), result["tasks"].size(), failed, cases);
        tests += result["tasks"].size();
        failures += failed;
    }
    return fmt::format("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites tests=\"{}\" "
                       "failures=\"{}\">\n{}</testsuites>\n",
                       tests, failures, suites);
}

namespace {

/// Students by the share of a task's points that they have: none, below half, half or more, all.
std::string distribution_rows(const std::vector<ordered_json>& results) {
    std::string rows;
    const std::size_t tasks = results.empty() ? 0 : results[0]["tasks"].size();
    for (std::size_t t = 0; t < tasks; ++t) {
        std::array<int, 4> counts{};
        double points = 0.0;
        const ordered_json& task = results[0]["tasks"][t];
        for (const ordered_json& result : results) {
            const double got = number(result["tasks"][t], "points"), of = number(result["tasks"][t], "of");
            points += got;
            ++counts[got <= 0.0 ? 0u : got >= of ? 3u : got < 0.5 * of ? 1u : 2u];
        }
        rows +=
            fmt::format("<tr><th>{}<td>{:.2g} of {:g}<td><meter max=\"{:g}\" value=\"{:g}\"></meter>",
                        escape_markup(heading(task)), points / static_cast<double>(results.size()),
                        number(task, "of"), number(task, "of"), points / static_cast<double>(results.size()));
        for (const int count : counts) rows += fmt::format("<td>{}", count);
        rows += "\n";
    }
    return rows;
}

/// Mistakes by how many students made them.
std::string mistake_rows(const std::vector<ordered_json>& results) {
    std::map<std::pair<std::string, std::string>, std::vector<const ordered_json*>> students;
    for (const ordered_json& result : results)
        for (const ordered_json& task : result["tasks"]) {
            std::map<std::string, bool> seen;
            for (const ordered_json& check : task["checks"])
                if (!check["diagnosis"].is_null()) seen[word(check["diagnosis"], "text")] = true;
            if (word(task, "status") == "broken")
                seen["does not compile, does not end, or was refused"] = true;
            for (const auto& [text, is_seen] : seen) students[{word(task, "id"), text}].push_back(&result);
        }
    std::vector<std::pair<std::size_t, std::string>> rows;
    for (const auto& [mistake, who] : students) {
        std::string links;
        for (const ordered_json* result : who)
            links +=
                fmt::format(" <a href=\"students/{0}.html#{1}\">{2}</a>", escape_markup(word(*result, "key")),
                            escape_markup(mistake.first), escape_markup(word(*result, "name")));
        rows.emplace_back(
            who.size(),
            fmt::format("<tr><td>{}<td>{}<td>{}<td><details><summary>who</summary>{}</details>\n", who.size(),
                        escape_markup(mistake.first), escape_markup(shown(mistake.second)), links));
    }
    std::ranges::stable_sort(rows, [](const auto& a, const auto& b) { return a.first > b.first; });
    std::string text;
    for (std::size_t i = 0; i < std::min<std::size_t>(rows.size(), 40); ++i) text += rows[i].second;
    return text;
}

std::string student_rows(const std::vector<ordered_json>& results) {
    std::string rows;
    for (const ordered_json& result : results) {
        rows += fmt::format("<tr><th><a href=\"students/{}.html\">{}</a><td>{}<td>{:g} of {:g}<td>{:.0f} %",
                            escape_markup(word(result, "key")), escape_markup(word(result, "name")),
                            escape_markup(word(result, "student")), number(result, "points"),
                            number(result, "of"), number(result, "percent"));
        for (const ordered_json& task : result["tasks"])
            rows +=
                fmt::format("<td class=\"{}\">{:g}", word(task, "status") == "passed" ? "passed" : "failed",
                            number(task, "points"));
        rows += "<td>";
        for (const std::string& remark : remarks_of(result)) rows += escape_markup(remark) + "<br>";
        rows += "\n";
    }
    return rows;
}

constexpr const char* overview_style =
    "body { font: 15px/1.45 system-ui, sans-serif; margin: 24px; color-scheme: light dark; }\n"
    "table { border-collapse: collapse; margin: 8px 0 28px; }\n"
    "th, td { padding: 3px 12px 3px 0; text-align: left; vertical-align: top; border-bottom: 1px solid "
    "#8884; }\n"
    "td { font-variant-numeric: tabular-nums; }\n"
    ".failed { font-weight: 600; }\n.failed::after { content: \" \\2717\"; }\n";

} // namespace

std::string overview_html(const std::vector<ordered_json>& results) {
    const std::string assignment = results.empty() ? "" : word(results[0], "assignment");
    double percent = 0.0;
    for (const ordered_json& result : results)
        percent += number(result, "percent") / static_cast<double>(results.size());
    std::string ids;
    if (!results.empty())
        for (const ordered_json& task : results[0]["tasks"]) ids += "<th>" + escape_markup(word(task, "id"));
    return fmt::format(
        "<!doctype html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n"
        "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src "
        "'unsafe-inline'\">\n"
        "<meta name=\"viewport\" content=\"width=device-width\">\n<title>{0}: {1} "
        "submissions</title>\n<style>\n{2}</style>\n"
        "<h1>{0}: {1} submissions, {3:.0f} % on average</h1>\n"
        "<h2>Tasks</h2>\n<table>\n<tr><th>task<th>average points<th><th>none<th>below half<th>half or "
        "more<th>all\n{4}</table>\n"
        "<h2>Commonest mistakes</h2>\n<table>\n<tr><th>students<th>task<th>mistake<th>\n{5}</table>\n"
        "<h2>Students</h2>\n<table>\n<tr><th>name<th>id<th>points<th>{6}<th>remarks\n{7}</table>\n",
        escape_markup(assignment), results.size(), overview_style, percent, distribution_rows(results),
        mistake_rows(results), ids, student_rows(results));
}

namespace {

constexpr std::size_t max_scope_bytes = 512 << 10; // of all pictures of a results.json

/// The pictures of checks that failed, yours beside the reference, in the reference's exposure, as HTML.
/// `left`: bytes that they may still have.
std::string pictures_of(const ordered_json& task, std::size_t& left) {
    std::string markup;
    for (const ordered_json& check : task["checks"]) {
        const auto pictures = check.find("pictures");
        if (pictures == check.end() || check["passed"].get<bool>()) continue;
        const auto yours = golden::unpack_pixels(pictures->value("yours", ordered_json()));
        const ordered_json other = pictures->value("reference", ordered_json());
        const auto reference = other == "equal" ? yours : golden::unpack_pixels(other);
        if (!yours || !reference) continue;
        const float exposure = image::auto_ev100(*reference);
        std::string part;
        for (const auto& [picture, caption] : {std::pair{&*yours, "yours"}, {&*reference, "the reference"}})
            part += fmt::format("<p>{}: {}<br><img alt=\"{}\" src=\"data:image/png;base64,{}\"></p>\n",
                                escape_markup(shown(word(check, "name"))), caption, caption,
                                golden::png_data(image::displayed(*picture, exposure)));
        if (part.size() > left)
            part = fmt::format("<p>{}: its pictures are too large to be shown here</p>\n",
                               escape_markup(shown(word(check, "name"))));
        else
            left -= part.size();
        markup += part;
    }
    return markup;
}

} // namespace

ordered_json gradescope_of(const ordered_json& result) {
    ordered_json tests = ordered_json::array();
    std::size_t left = max_scope_bytes;
    for (const ordered_json& task : result["tasks"]) {
        const bool passed = word(task, "status") == "passed";
        const std::string text = explanation(task), pictures = pictures_of(task, left);
        tests.push_back(
            {{"name", heading(task)},
             {"name_format", "text"},
             {"number", word(task, "id")},
             {"score", number(task, "points")},
             {"max_score",
              task.value("extra", false) ? 0.0 : number(task, "of")}, // points above are extra credit
             {"status", passed ? "passed" : "failed"},
             {"output", pictures.empty() ? text : "<pre>" + escape_markup(text) + "</pre>\n" + pictures},
             {"output_format", pictures.empty() ? "text" : "html"},
             {"visibility", "visible"}});
    }
    std::string output = fmt::format("{}: {:g} of {:g} points", word(result, "assignment"),
                                     number(result, "points"), number(result, "of"));
    for (const std::string& remark : remarks_of(result)) output += "\n" + remark;
    return {{"score", number(result, "points")}, {"output", output},
            {"output_format", "text"},           {"visibility", "visible"},
            {"stdout_visibility", "hidden"},     {"tests", tests}};
}

std::string vpl_of(const ordered_json& result, double grade_max) {
    std::string text;
    for (const ordered_json& task : result["tasks"]) {
        text += fmt::format("Comment :=>>-{} ({:g} of {:g} points)\n", shown(heading(task)),
                            number(task, "points"), number(task, "of"));
        std::istringstream lines(explanation(task));
        for (std::string line; std::getline(lines, line);) text += "Comment :=>> " + line + "\n";
    }
    const double share = std::clamp(number(result, "percent") / 100.0, 0.0, 1.0);
    return text + fmt::format("Grade :=>> {:g}\n", std::round(100.0 * share * grade_max) / 100.0);
}

} // namespace sr::assignment
