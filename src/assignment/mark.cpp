#include "assignment/mark.hpp"

#include "assignment/compile_problem.hpp"
#include "assignment/value_check.hpp"
#include "core/markup.hpp"
#include "glsl/untrusted.hpp"
#include "golden/page.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace sr::assignment {
namespace {

using nlohmann::ordered_json;

ordered_json begun(const Task& task) {
    return {{"id", task.id},
            {"title", task.title},
            {"extra", task.is_extra},
            {"status", "failed"},
            {"points", 0.0},
            {"of", task.points()},
            {"problems", ordered_json::array()},
            {"checks", ordered_json::array()}};
}

ordered_json broken(const Task& task, const std::vector<Problem>& problems) {
    ordered_json result = begun(task);
    result["status"] = "broken";
    for (const Problem& p : problems)
        result["problems"].push_back({{"file", p.place},
                                      {"line", p.line},
                                      {"column", p.column},
                                      {"text", p.text},
                                      {"source", p.source},
                                      {"hint", p.hint}});
    return result;
}

/// Yours and the reference's, as reports carry them.
ordered_json packed(const Finding& finding) {
    ordered_json yours = golden::pack_pixels(*finding.picture),
                 reference = golden::pack_pixels(*finding.reference);
    if (reference == yours) reference = "equal";
    return {{"yours", std::move(yours)}, {"reference", std::move(reference)}};
}

/// A text filled with blanks to a width in code points.
std::string padded(const std::string& text, std::size_t width) {
    std::size_t length = 0;
    for (const char c : text) length += (c & 0xc0) != 0x80;
    return text + std::string(length < width ? width - length : 1, ' ');
}

std::string check_lines(const ordered_json& check) {
    const bool passed = check["passed"];
    std::string text =
        fmt::format("    {} {} {:g}/{:g}", passed ? "ok    " : "WRONG ", padded(check["name"], 16),
                    check["points"].get<double>(), check["of"].get<double>());
    const auto word = [&](const char* key) { return check[key].get<std::string>(); };
    if (passed) return text + "\n";
    const bool has_unit = !word("unit").empty() && word("unit") != "1"; // 1: a number without a unit
    text += "  " + word("message");
    if (!word("got").empty())
        text += fmt::format("\n           got {}, expected {}{}{}, at {}", word("got"), word("expected"),
                            has_unit ? " " : "", has_unit ? word("unit") : "", word("at"));
    if (!check["diagnosis"].is_null())
        text += fmt::format("\n           {}: {}", check["diagnosis"]["name"].get<std::string>(),
                            check["diagnosis"]["text"].get<std::string>());
    const bool repeats = !check["diagnosis"].is_null() && check["diagnosis"]["text"] == check["hint"];
    if (!word("hint").empty() && !repeats) text += "\n           hint: " + word("hint");
    return text + "\n";
}

} // namespace

Finding Marker::found(const Task& task, const Check& check, const Codes& codes) {
    if (check.kind == Check::Kind::samples) return check_samples(assignment_, parameters_, check, codes);
    if (check.kind == Check::Kind::slope) return check_slope(assignment_, parameters_, check, codes);
    if (check.kind == Check::Kind::image) {
        Finding finding = pictures_.check(check, codes);
        if (!finding.passed && finding.is_implemented && last_mistake_.empty())
            finding.diagnosis = pictures_.diagnose(task, check, finding);
        return finding;
    }
    const Inputs inputs = inputs_of(check.inputs, check.rows, check.mean_over, check.mean_count, check.seed);
    const Compared compared = compare_values(known_, assignment_, parameters_, check, codes, inputs);
    Finding finding = judge(check, compared, inputs);
    if (!finding.passed && finding.is_implemented)
        finding.diagnosis = sr::assignment::diagnose(known_, assignment_, parameters_, task, check, compared,
                                                     inputs, last_mistake_);
    return finding;
}

/// The result of a check of which a student learns nothing but whether it passed.
ordered_json Marker::mark_hidden(const Task& task, const Check& check, const Codes& codes) {
    bool passed = false;
    const std::string mistake_before = last_mistake_;
    try {
        passed = found(task, check, codes).passed;
    } catch (const gl::ShaderError&) {
    } catch (const glsl::LoopError&) {
    }
    last_mistake_ = mistake_before;
    return {{"name", check.name},
            {"hidden", true},
            {"passed", passed},
            {"implemented", true},
            {"points", passed ? check.points : 0.0},
            {"of", check.points},
            {"got", ""},
            {"expected", ""},
            {"unit", ""},
            {"at", ""},
            {"message", passed ? "" : "a hidden check"},
            {"diagnosis", nullptr},
            {"hint", ""}};
}

ordered_json Marker::mark_check(const Task& task, const Check& check, const Codes& codes) {
    if (check.is_hidden) return mark_hidden(task, check, codes);
    Finding finding;
    try {
        finding = found(task, check, codes);
    } catch (const glsl::LoopError& error) {
        finding = {};
        finding.message = error.what();
    }
    // A mistake that an earlier check named is the likeliest cause of what this one cannot name.
    if (!finding.passed && finding.is_implemented && !finding.diagnosis && !last_mistake_.empty())
        finding.diagnosis = Named{last_mistake_, task.hints.at(last_mistake_)};
    if (finding.diagnosis && task.hints.contains(finding.diagnosis->name) && last_mistake_.empty())
        for (const Variant& variant : task.variants)
            if (variant.name == finding.diagnosis->name) last_mistake_ = variant.name;
    ordered_json result{{"name", check.name},
                        {"passed", finding.passed},
                        {"implemented", finding.is_implemented},
                        {"points", finding.passed ? check.points : 0.0},
                        {"of", check.points},
                        {"got", finding.got},
                        {"expected", finding.expected},
                        {"unit", check.unit},
                        {"at", finding.at},
                        {"message", finding.message},
                        {"diagnosis", nullptr},
                        {"hint", finding.passed ? "" : hint_for(task, check, finding)}};
    if (finding.diagnosis)
        result["diagnosis"] = {{"name", finding.diagnosis->name}, {"text", finding.diagnosis->text}};
    if (keeps_pictures_ && finding.picture && finding.reference) result["pictures"] = packed(finding);
    return result;
}

const ReferenceValues& Marker::compute_references(bool mistakes) {
    for (const Task& task : assignment_.tasks)
        for (const Check& check : task.checks) {
            if (check.kind == Check::Kind::image) pictures_.compute_references(task, check, mistakes);
            if (check.kind != Check::Kind::value) continue;
            const Inputs inputs =
                inputs_of(check.inputs, check.rows, check.mean_over, check.mean_count, check.seed);
            if (check.relation == Check::Relation::reference || inputs.group == 1)
                reference_values(known_, assignment_, parameters_, check, inputs);
            for (const Variant& variant : task.variants)
                if (mistakes && variant.is_mistake && !check.is_hidden)
                    mistaken_values(known_, assignment_, parameters_, task, variant, check, inputs);
        }
    return known_;
}

ordered_json Marker::mark(const Task& task, const Submission& submission) {
    if (const auto fault = submission.faults.find(task.id); fault != submission.faults.end())
        return broken(task, {{"", 0, 0, fault->second, {}, {}}});
    Codes codes{{task.id, submission.codes.at(task.id)}};
    if (const auto helpers = submission.codes.find(std::string(helpers_region));
        helpers != submission.codes.end())
        codes.insert(*helpers);
    last_mistake_.clear();
    ordered_json result = begun(task);
    bool is_implemented = true;
    double points = 0.0;
    try {
        for (const Check& check : task.checks) {
            if (!is_implemented) break;
            result["checks"].push_back(mark_check(task, check, codes));
            points += result["checks"].back()["points"].get<double>();
            is_implemented = result["checks"].back()["implemented"];
        }
    } catch (const gl::ShaderError& error) {
        return broken(task, problems_of(error, task.id, codes));
    } catch (const Error& error) { // an #include or a comment of theirs; else the assignment is at fault
        const std::string words = error.what();
        if (std::ranges::none_of(codes,
                                 [&](const auto& code) { return words.starts_with(code.second.place); }))
            throw;
        return broken(task, {{"", 0, 0, words, {}, {}}});
    }
    if (!is_implemented) {
        result["status"] = "not implemented";
        result["checks"] = ordered_json::array();
        return result;
    }
    result["points"] = points;
    result["status"] = points >= task.points() ? "passed" : "failed";
    return result;
}

ordered_json ended_early(const Task& task, const std::string& why) {
    ordered_json result = broken(task, {{"", 0, 0, why, {}, "Look for a loop that does not end."}});
    result["ended_early"] = true;
    return result;
}

ordered_json sum_of(const Assignment& assignment, const std::string& student, const ordered_json& tasks) {
    double points = 0.0;
    for (const ordered_json& task : tasks) points += task["points"].get<double>();
    const double of = assignment.points();
    return {{"assignment", assignment.id},
            {"title", assignment.title},
            {"student", student},
            {"points", points},
            {"of", of},
            {"percent", of > 0.0 ? 100.0 * points / of : 0.0},
            {"tasks", tasks}};
}

ordered_json without_pictures(ordered_json result) {
    for (ordered_json& task : result["tasks"])
        for (ordered_json& check : task["checks"]) check.erase("pictures");
    return result;
}

std::string table_of(const ordered_json& result) {
    std::string text =
        fmt::format("{}: {}\n", result["assignment"].get<std::string>(), result["title"].get<std::string>());
    for (const ordered_json& task : result["tasks"]) {
        text += fmt::format("\n{} {} {:g}/{:g}  {}{}\n", task["id"].get<std::string>(),
                            padded(task["title"], 44), task["points"].get<double>(), task["of"].get<double>(),
                            task["status"].get<std::string>(), task["extra"].get<bool>() ? " (extra)" : "");
        for (const ordered_json& p : task["problems"]) {
            const int line = p["line"], column = p["column"];
            text += "    ";
            if (line > 0)
                text += fmt::format("{}:{}:{} ", p["file"].get<std::string>(), line,
                                    column > 0 ? fmt::format("{}:", column) : "");
            text += p["text"].get<std::string>() + "\n";
            if (!p["source"].get<std::string>().empty())
                text += "        | " + p["source"].get<std::string>() + "\n";
            if (!p["hint"].get<std::string>().empty())
                text += "        hint: " + p["hint"].get<std::string>() + "\n";
        }
        for (const ordered_json& check : task["checks"]) text += check_lines(check);
    }
    return text
           + fmt::format("\n{:g} of {:g} points, {:.0f} %\n", result["points"].get<double>(),
                         result["of"].get<double>(), result["percent"].get<double>());
}

namespace {

std::string cells(std::initializer_list<std::string> texts) {
    std::string row = "<tr>";
    for (const std::string& text : texts) row += "<td>" + escape_markup(text);
    return row + "\n";
}

/// The table that shows where the script may not run.
std::string plain_table(const ordered_json& result) {
    std::string rows;
    for (const ordered_json& task : result["tasks"]) {
        const std::string id = task["id"];
        if (task["checks"].empty())
            rows += cells({id, "", task["status"], "", "", "",
                           task["problems"].empty() ? "" : task["problems"][0]["text"].get<std::string>()});
        for (const ordered_json& check : task["checks"])
            rows += cells({id, check["name"], check["passed"].get<bool>() ? "passed" : "failed", check["got"],
                           check["expected"], check["unit"], check["hint"]});
    }
    return "<table>\n<tr><th>task<th>check<th>verdict<th>got<th>expected<th>unit<th>hint\n" + rows
           + "</table>\n";
}

} // namespace

std::string report_html(const ordered_json& result) {
    const std::string student = result["student"];
    const std::string title = fmt::format(
        "{}{}: {:g} of {:g} points", result["assignment"].get<std::string>(),
        student.empty() ? "" : " of " + student, result["points"].get<double>(), result["of"].get<double>());
    return golden::offline_page(title, plain_table(result),
                                result.dump(-1, ' ', false, ordered_json::error_handler_t::replace),
                                marks_page());
}

} // namespace sr::assignment
