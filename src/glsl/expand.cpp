#include "glsl/source.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <functional>
#include <set>

namespace sr::glsl {
namespace {

constexpr std::string_view blank = " \t\v\f";

std::string_view without_blanks_before(std::string_view text) {
    text.remove_prefix(std::min(text.find_first_not_of(blank), text.size()));
    return text;
}

std::string_view without_blanks_after(std::string_view text) {
    return text.substr(0, text.find_last_not_of(blank) + 1);
}

bool has(std::string_view text, std::string_view part) { return text.find(part) != text.npos; }

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

/// What follows `#name` on a line; absent if the line is no such directive.
std::optional<std::string_view> directive(std::string_view code, std::string_view name) {
    code = without_blanks_before(code);
    if (!code.starts_with('#')) return std::nullopt;
    code = without_blanks_before(code.substr(1));
    if (!code.starts_with(name)) return std::nullopt;
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
    Source take() { return std::move(source_); }

private:
    struct Found {
        std::string place;
        std::string text;
    };

    Found find(std::string_view name, const Location& includer) const;
    void add_lines(std::string_view text, int file);
    void check_version(const Location& here) const;
    void include(std::string_view argument, const Location& here);

    std::span<const Root> path_;
    Source source_;
    std::set<std::string, std::less<>> seen_;
    std::vector<std::string> open_; // the chain of includes from the entry to here
};

Expansion::Found Expansion::find(std::string_view name, const Location& includer) const {
    std::vector<std::string_view> labels;
    for (const Root& root : path_) {
        if (auto text = root.text_of(name)) return {root.place_of(name), std::move(*text)};
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
    add_lines(found.text, static_cast<int>(source_.files.size()) - 1);
    open_.pop_back();
}

void Expansion::add_lines(std::string_view text, int file) {
    if (text.starts_with("\xEF\xBB\xBF"))
        text.remove_prefix(3); // a byte order mark, which no GLSL compiler takes
    bool is_comment = false;
    int comment_line = 0;
    for (int number = 1; !text.empty(); ++number) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        if (line.ends_with('\r')) line.remove_suffix(1);

        const Location here{source_.files[static_cast<std::size_t>(file)], number};
        const bool was_comment = is_comment;
        const std::string code = code_of(line, is_comment);
        if (is_comment && !was_comment) comment_line = number;
        if (directive(code, "version")) check_version(here);
        if (const auto argument = directive(code, "include")) {
            if (was_comment || is_comment)
                throw Error(here, "a comment of several lines begins or ends beside #include",
                            "put it on lines of its own");
            include(*argument, here);
            continue;
        }
        source_.text.append(line) += '\n';
        source_.lines.push_back({file, number});
    }
    if (is_comment)
        throw Error({source_.files[static_cast<std::size_t>(file)], comment_line}, "this comment never ends",
                    "close it with */");
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

} // namespace sr::glsl
