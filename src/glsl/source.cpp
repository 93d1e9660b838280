#include "glsl/source.hpp"

#include "core/text.hpp"
#include "glsl/call_costs.hpp"
#include "glsl/tokens.hpp"
#include "glsl/untrusted.hpp"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <functional>
#include <set>

namespace sr::glsl {
namespace {

constexpr std::string_view blank = " \t\v\f";
constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF"; // which no GLSL compiler takes

std::string_view without_blanks_before(std::string_view text) {
    text.remove_prefix(std::min(text.find_first_not_of(blank), text.size()));
    return text;
}

std::string_view without_blanks_after(std::string_view text) {
    return text.substr(0, text.find_last_not_of(blank) + 1);
}

bool has(std::string_view text, std::string_view part) { return text.find(part) != text.npos; }

/// @throws Error at a NUL, where the text would end for the driver
void require_no_nul(std::string_view text, const std::string& place) {
    const std::size_t at = text.find('\0');
    if (at == text.npos) return;
    const auto line = 1 + std::ranges::count(text.substr(0, at), '\n');
    throw Error({place, static_cast<int>(line)}, "a NUL byte", "remove it: a shader is text");
}

/// A line without its comments. `is_comment` says whether a block comment is open, before and after the line.
std::string code_of(std::string_view line, bool& is_comment) {
    std::string code;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const std::string_view two = line.substr(i, 2);
        if (is_comment) {
            if (two != "*/") continue;
            is_comment = false;
            code += ' ';
            ++i;
        } else if (two == "//") {
            break;
        } else if (two == "/*") {
            is_comment = true;
            ++i;
        } else {
            code += line[i];
        }
    }
    return code;
}

/// Returns the text after a line's `#`; absent if the line is no directive.
std::optional<std::string_view> directive_text(std::string_view code) {
    code = without_blanks_before(code);
    if (!code.starts_with('#')) return std::nullopt;
    return without_blanks_before(code.substr(1));
}

/// The directive's name: `if`, `line`, …; empty if the line is no directive.
std::string_view directive_name(std::string_view code) {
    const std::string_view text = directive_text(code).value_or("");
    const auto is_letter = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
    };
    return text.substr(0, static_cast<std::size_t>(std::ranges::find_if_not(text, is_letter) - text.begin()));
}

/// Returns the text after `#name` on a line; absent if the line is no such directive.
std::optional<std::string_view> directive(std::string_view code, std::string_view name) {
    const auto text = directive_text(code);
    if (!text || !text->starts_with(name)) return std::nullopt;
    code = *text;
    code.remove_prefix(name.size());
    const bool ends_here =
        code.empty() || code.front() == '"' || code.front() == '<' || blank.find(code.front()) != blank.npos;
    if (!ends_here) return std::nullopt;
    return without_blanks_after(without_blanks_before(code));
}

/// The name between quotes: below a root, whichever it is.
std::optional<std::string_view> quoted_name(std::string_view text) {
    if (text.size() < 3 || text.front() != '"' || text.back() != '"') return std::nullopt;
    const std::string_view name = text.substr(1, text.size() - 2);
    const bool leaves_its_root = name.front() == '/' || has(name, "..") || has(name, ":");
    if (leaves_its_root || has(name, "\"") || has(name, "\\")) return std::nullopt;
    return name;
}

class Expansion {
public:
    explicit Expansion(std::span<const Root> path) : path_(path) {}

    void add(std::string_view name, const Location& includer);
    Source take();

private:
    struct Found {
        std::string place;
        std::string text;
        const Root* root = nullptr;
    };

    Found find(std::string_view name, const Location& includer) const;
    void add_lines(std::string_view text, int file);
    void check_version(const Location& here) const;
    void check_directive(std::string_view code, const Location& here);
    void include(std::string_view argument, const Location& here);

    std::span<const Root> path_;
    Source source_;
    std::set<std::string, std::less<>> seen_;
    std::vector<Location> conditions_; // the #if, #ifdef and #ifndef that are open
    std::vector<std::string> open_;    // the chain of includes from the entry to here
    std::string untrusted_code_;       // of all untrusted files
    std::string untrusted_place_;      // of the first
    bool has_several_untrusted_ = false;
};

Expansion::Found Expansion::find(std::string_view name, const Location& includer) const {
    std::vector<std::string_view> labels;
    for (const Root& root : path_) {
        if (auto text = root.text_of(name)) return {root.place_of(name), std::move(*text), &root};
        labels.push_back(root.label());
    }
    const std::string searched =
        labels.empty() ? "there are no roots" : fmt::format("{}", fmt::join(labels, ", "));
    if (includer.file.empty())
        throw Error({std::string(name)}, fmt::format("no such shader in the roots ({})", searched),
                    "check its name, which is relative to a root");
    throw Error(includer, fmt::format("includes \"{}\", which no root has (searched: {})", name, searched),
                "correct the name, which is relative to a root, or add the root that has the file");
}

void Expansion::add(std::string_view name, const Location& includer) {
    if (std::ranges::find(open_, name) != open_.end()) {
        const auto start = std::ranges::find(open_, name);
        const std::vector<std::string> chain(start, open_.end());
        throw Error(includer, fmt::format("include cycle: {} → {}", fmt::join(chain, " → "), name),
                    "move what both need into a file of its own");
    }
    if (!seen_.emplace(name).second) return;
    const Found found = find(name, includer);
    open_.emplace_back(name);
    source_.files.push_back(found.place);
    if (found.root->is_foreign()) source_.foreign.push_back(found.place);
    require_no_nul(found.text, found.place);
    std::string text = with_plain_breaks(found.text);
    if (found.root->is_untrusted()) {
        if (text.starts_with(byte_order_mark)) text.erase(0, byte_order_mark.size());
        Bounded safe = bounded(text, found.place, found.root->permitted());
        source_.loops.insert(source_.loops.end(), safe.loops.begin(), safe.loops.end());
        text = std::move(safe.text);
        if (untrusted_place_.empty())
            untrusted_place_ = found.place;
        else
            has_several_untrusted_ = true;
        untrusted_code_ += safe.code;
    }
    add_lines(text, static_cast<int>(source_.files.size()) - 1);
    open_.pop_back();
}

void Expansion::add_lines(std::string_view text, int file) {
    if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
    bool is_comment = false;
    int comment_line = 0;
    const std::size_t conditions_before = conditions_.size();
    std::string code; // of this line, and of those that it continues
    for (int number = 1; !text.empty(); ++number) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));

        const Location here{source_.files[static_cast<std::size_t>(file)], number};
        const bool was_comment = is_comment;
        code += code_of(line, is_comment);
        if (is_comment && !was_comment) comment_line = number;
        const bool goes_on = code.ends_with('\\');
        if (!goes_on) check_directive(code, here);
        if (const auto argument = directive(code, "include")) {
            if (was_comment || is_comment)
                throw Error(here, "a comment of several lines begins or ends beside #include",
                            "put it on lines of its own");
            include(*argument, here);
            code.clear();
            continue;
        }
        if (goes_on)
            code.pop_back();
        else if (!is_comment || directive_text(code) != "") // "#" and its word may stand around a comment
            code.clear();
        source_.text.append(line) += '\n';
        source_.lines.push_back({file, number});
    }
    const int last = source_.lines.empty() ? 1 : source_.lines.back().line;
    if (source_.text.ends_with("\\\n") && !source_.lines.empty() && source_.lines.back().file == file)
        throw Error({source_.files[static_cast<std::size_t>(file)], last}, "the last line ends in \\",
                    "remove that: no line follows in this file");
    if (conditions_.size() > conditions_before)
        throw Error(conditions_.back(), "this #if never ends", "close it with #endif in the same file");
    if (is_comment)
        throw Error({source_.files[static_cast<std::size_t>(file)], comment_line}, "this comment never ends",
                    "close it with */");
}

void Expansion::check_directive(std::string_view code, const Location& here) {
    const std::string_view name = directive_name(code);
    if (name == "version") check_version(here);
    if (name == "line")
        throw Error(here, "#line would give errors another place",
                    "remove it: the place is known without it");
    if (name == "if" || name == "ifdef" || name == "ifndef") conditions_.push_back(here);
    if (name == "endif") {
        const bool is_open = !conditions_.empty() && conditions_.back().file == here.file;
        if (!is_open) throw Error(here, "#endif without #if", "write both into the same file");
        conditions_.pop_back();
    }
}

void Expansion::check_version(const Location& here) const {
    if (open_.size() > 1)
        throw Error(here, "#version in a file that is included", "leave it to the file that includes");
    if (here.line != 1) throw Error(here, "#version comes too late", "make it the first line of the file");
}

void Expansion::include(std::string_view argument, const Location& here) {
    const auto name = quoted_name(argument);
    if (!name)
        throw Error(here, "malformed #include",
                    "write #include \"folder/file.glsl\", with a name relative to a root and without '..'");
    add(*name, here);
}

/// The output of a fragment shader that can say that a loop was stopped; empty if it has none.
std::string_view telling_output(std::string_view text) {
    for (const std::string_view out : {"film", "answer", "receiver"})
        if (text.find(fmt::format("out vec4 {};", out)) != text.npos) return out;
    return {};
}

Source Expansion::take() {
    // The functions of one untrusted file may call those of another.
    if (has_several_untrusted_)
        require_low_costs(tokenize(untrusted_code_, untrusted_place_), untrusted_place_);
    if (source_.loops.empty()) return std::move(source_);
    const std::string_view out = telling_output(source_.text);
    const std::string before = std::string(turn_counter()) + std::string(out.empty() ? "" : main_renamed());
    const bool has_version = source_.text.starts_with("#version");
    const std::size_t at = has_version ? source_.text.find('\n') + 1 : 0;
    source_.text.insert(at, before);
    source_.lines.insert(source_.lines.begin() + (has_version ? 1 : 0),
                         static_cast<std::size_t>(std::ranges::count(before, '\n')), {0, 1});
    if (out.empty()) return std::move(source_);
    const std::string behind = main_that_tells(out);
    source_.text += behind;
    source_.lines.insert(source_.lines.end(), static_cast<std::size_t>(std::ranges::count(behind, '\n')),
                         source_.lines.back());
    return std::move(source_);
}

} // namespace

Location Source::location(int flat_line) const {
    if (flat_line < 1 || lines.empty()) return {files.empty() ? std::string("shader") : files.front()};
    const std::size_t last = lines.size() - 1;
    const Line& line = lines[std::min(static_cast<std::size_t>(flat_line) - 1, last)];
    return {files[static_cast<std::size_t>(line.file)], line.line};
}

Source expand(std::span<const Root> path, std::string_view file) {
    Expansion expansion(path);
    expansion.add(file, {});
    return expansion.take();
}

bool declares(std::string_view text, std::string_view function) {
    const auto is_word = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
    constexpr std::string_view blanks = " \t\r\n\v\f";
    for (auto at = text.find(function); at != text.npos; at = text.find(function, at + 1)) {
        const std::string_view after = text.substr(at + function.size());
        const auto open = after.find_first_not_of(blanks);
        if ((at > 0 && is_word(text[at - 1])) || open == after.npos || after[open] != '(') continue;
        const auto brace = after.find_first_of(";{", open);
        if (brace == after.npos || after[brace] == ';') continue;
        const auto last = after.find_last_not_of(blanks, brace - 1);
        if (after[last] == ')') return true;
    }
    return false;
}

} // namespace sr::glsl
