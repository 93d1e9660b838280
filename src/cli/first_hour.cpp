#include "cli/first_hour.hpp"

#include "cli/first_hour_text.hpp"
#include "core/markup.hpp"

#include <fmt/format.h>
#include <regex>
#include <sstream>
#include <utility>

namespace sr::cli {
namespace {

/// Code and links of a line of Markdown. Links lead to files that the page does not have: their text stays.
std::string with_code(const std::string& line) {
    static const std::regex code("`([^`]*)`"), link(R"(\[([^\]]*)\]\([^)]*\))");
    return std::regex_replace(std::regex_replace(escape_markup(line), link, "$1"), code, "<code>$1</code>");
}

/// Collects the lines of a paragraph.
class Paragraphs {
public:
    void add(const std::string& line) { text_ += (text_.empty() ? "" : " ") + with_code(line); }
    std::string taken() {
        const std::string text = std::exchange(text_, {});
        return text.empty() ? text : fmt::format("<p>{}</p>\n", text);
    }

private:
    std::string text_;
};

} // namespace

std::string first_hour_html() {
    std::istringstream lines{std::string(first_hour_text)};
    std::string html;
    Paragraphs paragraph;
    bool is_verbatim = false;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("```")) {
            html += paragraph.taken() + (is_verbatim ? "</pre>\n" : "<pre>");
            is_verbatim = !is_verbatim;
        } else if (is_verbatim) {
            html += escape_markup(line) + "\n";
        } else if (line.starts_with("## ")) {
            html += paragraph.taken() + fmt::format("<h3>{}</h3>\n", with_code(line.substr(3)));
        } else if (line.starts_with("# ")) {
            html += fmt::format("<h2>{}</h2>\n", with_code(line.substr(2)));
        } else if (line.empty()) {
            html += paragraph.taken();
        } else {
            paragraph.add(line);
        }
    }
    return html + paragraph.taken();
}

} // namespace sr::cli
