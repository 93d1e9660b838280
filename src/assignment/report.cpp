#include "assignment/report.hpp"

#include "golden/page.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace sr::assignment {
namespace {

using nlohmann::ordered_json;

std::string cells(std::initializer_list<std::string> texts) {
    std::string row = "<tr>";
    for (const std::string& text : texts) row += "<td>" + golden::escape_markup(text);
    return row + "\n";
}

/// What is seen where the script may not run.
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
