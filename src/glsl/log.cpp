#include "glsl/log.hpp"

#include <algorithm>
#include <charconv>
#include <fmt/format.h>

namespace sr::glsl {
namespace {

/// Reads a line from left to right.
class Scanner {
public:
    explicit Scanner(std::string_view text) : rest_(text) {}

    bool take(std::string_view expected) {
        if (!rest_.starts_with(expected)) return false;
        rest_.remove_prefix(expected.size());
        return true;
    }

    std::optional<int> take_number() {
        int value = 0;
        const auto [end, problem] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
        if (problem != std::errc() || value < 0) return std::nullopt;
        rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
        return value;
    }

    /// "error", "preprocessor error", "fatal error", "warning", …; nothing is taken if there is none.
    std::optional<std::string> take_severity() {
        for (const std::string_view word : {"error", "warning", "note"}) {
            const std::size_t at = rest_.find(word);
            const std::string_view before = rest_.substr(0, at);
            const bool is_words = before.find_first_not_of("abcdefghijklmnopqrstuvwxyz ") == before.npos;
            const std::string_view after = at == rest_.npos ? "" : rest_.substr(at + word.size());
            const bool ends = after.starts_with(':') || after.starts_with(' ') || after.starts_with('(');
            if (at == rest_.npos || !is_words || !ends) continue;
            const std::string severity(rest_.substr(0, at + word.size()));
            rest_ = after;
            return severity;
        }
        return std::nullopt;
    }

    /// Returns the remaining text without leading blanks.
    std::string_view rest() const {
        return rest_.substr(std::min(rest_.find_first_not_of(' '), rest_.size()));
    }

private:
    std::string_view rest_;
};

struct Parsed {
    int line = 0;
    int column = 0;
    std::string severity;
    std::string text;
};

// We compile one string, whose number is 0.

/// 0:LINE(COL): error: …
std::optional<Parsed> parse_mesa(Scanner scan) {
    if (!scan.take("0:")) return std::nullopt;
    const auto line = scan.take_number();
    if (!line || !scan.take("(")) return std::nullopt;
    const auto column = scan.take_number();
    if (!column || !scan.take("): ")) return std::nullopt;
    const auto severity = scan.take_severity();
    if (!severity || !scan.take(":")) return std::nullopt;
    return Parsed{*line, *column, *severity, std::string(scan.rest())};
}

/// 0(LINE) : error C1234: …
std::optional<Parsed> parse_nvidia(Scanner scan) {
    if (!scan.take("0(")) return std::nullopt;
    const auto line = scan.take_number();
    if (!line || !(scan.take(") : ") || scan.take("): "))) return std::nullopt;
    const auto severity = scan.take_severity();
    if (!severity) return std::nullopt;
    return Parsed{*line, 0, *severity, std::string(scan.rest())};
}

/// ERROR: 0:LINE: …, AMD's with a second "error(#143) " behind it.
std::optional<Parsed> parse_colons(Scanner scan) {
    const bool is_error = scan.take("ERROR: 0:");
    if (!is_error && !scan.take("WARNING: 0:")) return std::nullopt;
    const auto line = scan.take_number();
    if (!line || !scan.take(":")) return std::nullopt;
    std::string_view text = scan.rest();
    for (const std::string_view again : {"error(", "warning("})
        if (text.starts_with(again)) text.remove_prefix(again.size() - 1);
    return Parsed{*line, 0, is_error ? "error" : "warning", std::string(text)};
}

/// Cuts a log into its lines; a last line without its end counts.
std::vector<std::string_view> lines_of(std::string_view log) {
    std::vector<std::string_view> lines;
    while (!log.empty()) {
        const std::size_t end = std::min(log.find('\n'), log.size());
        std::string_view line = log.substr(0, end);
        log.remove_prefix(std::min(end + 1, log.size()));
        while (line.ends_with('\r') || line.ends_with('\0')) line.remove_suffix(1);
        lines.push_back(line);
    }
    return lines;
}

} // namespace

std::string Complaint::line() const { return fmt::format("{}: {}: {}", where.text(), severity, text); }

std::optional<Complaint> complaint(std::string_view log_line, const Source& source) {
    for (const auto parse : {parse_mesa, parse_nvidia, parse_colons}) {
        const auto parsed = parse(Scanner(log_line));
        if (!parsed) continue;
        Location where = source.location(parsed->line);
        where.column = parsed->column;
        return Complaint{std::move(where), parsed->severity, parsed->text,
                         parsed->severity.ends_with("error")};
    }
    return std::nullopt;
}

std::string rewrite_log(std::string_view driver_log, const Source& source) {
    std::string rewritten;
    for (const std::string_view line : lines_of(driver_log)) {
        const auto found = complaint(line, source);
        rewritten += found ? found->line() : std::string(line);
        rewritten += '\n';
    }
    return rewritten;
}

std::optional<Complaint> first_error(std::string_view driver_log, const Source& source) {
    for (const std::string_view line : lines_of(driver_log))
        if (auto found = complaint(line, source); found && found->is_error) return found;
    return std::nullopt;
}

} // namespace sr::glsl
