#include "assignment/tick.hpp"
#include "core/markup.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace sr::assignment {
namespace {

using nlohmann::ordered_json;

constexpr const char* sheet_style =
    "@page { size: A4; margin: 9mm; }\n"
    "body { font: 8pt/1.25 system-ui, 'DejaVu Sans', sans-serif; margin: 0 auto; max-width: 192mm; color: "
    "#111; "
    "background: #fff; }\n"
    "h1 { font-size: 13pt; margin: 0; } h2 { font-size: 9.6pt; margin: 0 0 1mm; }\n"
    "header { display: flex; justify-content: space-between; align-items: baseline; border-bottom: 0.5mm "
    "solid "
    "#111; padding-bottom: 1mm; }\n"
    ".top { display: grid; grid-template-columns: 60mm 1fr; gap: 4mm; margin: 2mm 0; }\n"
    "table { border-collapse: collapse; } td, th { text-align: left; vertical-align: top; padding: 0 2mm "
    "0.3mm 0; "
    "font-weight: 400; }\n"
    ".finding { color: #a11; font-size: 7.6pt; }\n"
    "code, pre { font: 7pt/1.25 'DejaVu Sans Mono', ui-monospace, monospace; } code { overflow-wrap: "
    "anywhere; "
    "background: #eee; }\n"
    ".code td { padding: 0 1mm 0 0; } .code td:last-child { white-space: pre-wrap; overflow-wrap: anywhere; "
    "}\n"
    ".code td, .code th { font: 6.6pt/1.25 'DejaVu Sans Mono', ui-monospace, monospace; }\n"
    ".code th { font-weight: 700; padding-top: 0.6mm; } .number { color: #777; text-align: right; }\n"
    ".much td:last-child { background: #fdf0b8; }\n"
    ".questions { display: grid; grid-template-columns: 1fr 1fr; gap: 2mm 4mm; }\n"
    "section { border-top: 0.3mm solid #111; padding-top: 1mm; break-inside: avoid; }\n"
    ".ask { font-weight: 600; margin: 0 0 1mm; } .answer { margin: 0; padding-left: 3.5mm; }\n"
    "figure { display: inline-block; margin: 1mm 2mm 0 0; } figure img { width: 32mm; display: block; } "
    "figcaption { font-size: 7.4pt; color: #444; }\n"
    ".terms td, .terms th { font-size: 7.4pt; font-variant-numeric: tabular-nums; }\n"
    ".notes { height: 6mm; border-bottom: 0.2mm dotted #777; color: #777; font-size: 7.4pt; }\n"
    "@media screen { body { padding: 6mm; } }\n";

std::string text_in(const ordered_json& json, const char* key) { return json[key].get<std::string>(); }

/// Text in which `code` stands between backquotes.
std::string with_code(const std::string& text) {
    std::string markup = escape_markup(text);
    bool is_open = false;
    for (std::size_t at = 0; (at = markup.find('`', at)) != std::string::npos; is_open = !is_open)
        markup.replace(at, 1, is_open ? "</code>" : "<code>");
    return markup + (is_open ? "</code>" : "");
}

/// The first thing that is wrong with a task: the name of its mistake, or the message.
std::string finding_of(const ordered_json& task) {
    if (!task["problems"].empty()) return text_in(task["problems"][0], "text");
    for (const ordered_json& check : task["checks"])
        if (!check["passed"].get<bool>())
            return text_in(check, "name") + ": "
                   + (check["diagnosis"].is_null() ? text_in(check, "message")
                                                   : text_in(check["diagnosis"], "name"));
    return "";
}

std::string marks_table(const ordered_json& examination) {
    std::string rows;
    for (const ordered_json& task : examination["tasks"]) {
        const std::string finding = finding_of(task);
        rows += fmt::format(
            "<tr><th>{}<td>{:g}/{:g}<td>{}{}\n", escape_markup(text_in(task, "id")),
            task["points"].get<double>(), task["of"].get<double>(), escape_markup(text_in(task, "status")),
            finding.empty() ? "" : "<div class=\"finding\">" + escape_markup(finding) + "</div>");
    }
    return "<table>\n" + rows + "</table>\n";
}

std::string code_table(const ordered_json& code) {
    if (code.empty()) return "<p>No line differs from the template.</p>\n";
    std::size_t most = 0;
    for (const ordered_json& line : code) most = std::max(most, line["differs"].get<std::size_t>());
    std::string rows, task;
    for (const ordered_json& line : code) {
        if (text_in(line, "task") != task)
            rows += fmt::format("<tr><th colspan=\"2\">{} {}\n", escape_markup(text_in(line, "task")),
                                escape_markup(text_in(line, "file")));
        task = text_in(line, "task");
        rows += fmt::format("<tr{}><td class=\"number\">{}<td>{}\n",
                            2 * line["differs"].get<std::size_t>() > most ? " class=\"much\"" : "",
                            line["line"].get<int>(), escape_markup(text_in(line, "text")));
    }
    return "<table class=\"code\">\n" + rows + "</table>\n";
}

/// The probe's numbers of a pixel, by light.
std::string terms_table(const ordered_json& terms) {
    std::string rows;
    for (const ordered_json& light : terms["lights"]) {
        if (rows.size() > 1000) break; // of many lights the first few
        rows += fmt::format("<tr><td>{}<td>{}<td>{:.3g}<td>{:.3g}<td>{:.3g}<td>{:.3g}, {:.3g}, {:.3g}\n",
                            escape_markup(text_in(light, "name")),
                            light["cos"].is_null() ? "" : fmt::format("{:.2f}", light["cos"].get<double>()),
                            light["V"].get<double>(), light["E"].get<double>(), light["f_r"].get<double>(),
                            light["L_r"][0].get<double>(), light["L_r"][1].get<double>(),
                            light["L_r"][2].get<double>());
    }
    const ordered_json& L = terms["L_o"];
    return fmt::format(
        "<table class=\"terms\">\n<tr><th>light<th>cosθ<th>V<th>E [lx]<th>f_r [1/sr]<th>L R, G, B "
        "[cd/m²]\n{}<tr><td>L_o<td><td><td><td><td>{:.3g}, {:.3g}, {:.3g}\n</table>\n",
        rows, L[0].get<double>(), L[1].get<double>(), L[2].get<double>());
}

std::string question_section(const ordered_json& question, std::size_t number) {
    std::string answer, pictures;
    for (const ordered_json& line : question["answer"]) answer += "<li>" + with_code(line) + "\n";
    for (const ordered_json& picture : question["pictures"])
        pictures += fmt::format(
            "<figure><img alt=\"\" src=\"data:image/png;base64,{}\"><figcaption>{}</figcaption></figure>",
            escape_markup(text_in(picture, "png")), escape_markup(text_in(picture, "caption")));
    const std::string terms =
        text_in(question, "kind") == "pixel" ? terms_table(question["facts"]["terms"]) : std::string();
    return fmt::format(
        "<section>\n<h2>{}. {}</h2>\n<p class=\"ask\">{}</p>\n<ul class=\"answer\">\n{}</ul>\n{}{}\n"
        "<div class=\"notes\">notes</div>\n</section>\n",
        number, escape_markup(text_in(question, "title")), with_code(text_in(question, "ask")), answer, terms,
        pictures);
}

} // namespace

std::string tick_html(const ordered_json& examination) {
    const std::string student = text_in(examination, "student");
    const std::string title =
        fmt::format("{}: {}", text_in(examination, "assignment"), student.empty() ? "no id" : student);
    std::string questions, missing;
    for (std::size_t i = 0; i < examination["questions"].size(); ++i)
        questions += question_section(examination["questions"][i], i + 1);
    for (const ordered_json& line : examination["missing"])
        missing += "<p>No question: " + escape_markup(line.get<std::string>()) + ".</p>\n";
    return fmt::format(
        "<!doctype html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n"
        "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src "
        "'unsafe-inline'; img-src data:\">\n"
        "<meta name=\"viewport\" content=\"width=device-width\">\n<title>{0}</title>\n<style>\n{1}</style>\n"
        "<header><h1>{0}</h1><span>{2}, seed {3}</span><strong>{4:g} of {5:g} points</strong></header>\n"
        "<div class=\"top\">\n<div><h2>Marks</h2>\n{6}</div>\n<div><h2>Lines that differ most from the "
        "template</h2>\n{7}</div>\n</div>\n"
        "<div class=\"questions\">\n{8}</div>\n{9}",
        escape_markup(title), sheet_style, escape_markup(text_in(examination, "title")),
        escape_markup(text_in(examination, "seed")), examination["points"].get<double>(),
        examination["of"].get<double>(), marks_table(examination), code_table(examination["code"]), questions,
        missing);
}

} // namespace sr::assignment
