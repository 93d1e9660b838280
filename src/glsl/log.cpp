#include "glsl/log.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <fmt/format.h>
#include <regex>

namespace sr::glsl {
namespace {

/// A number of the log; what does not fit an int is no line number.
int number(const std::string& digits) {
    int value = 0;
    std::from_chars(digits.data(), digits.data() + digits.size(), value);
    return value;
}

std::string lower_case(std::string text) {
    std::ranges::transform(text, text.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

Complaint make_complaint(Location where, int column, std::string severity, std::string text) {
    where.column = column;
    const bool is_error = severity.ends_with("error");
    return {std::move(where), std::move(severity), std::move(text), is_error};
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
    // We compile one string, whose number is 0.
    static const std::regex mesa(R"(0:(\d+)\((\d+)\): ([a-z ]+): (.*))");
    static const std::regex nvidia(R"(0\((\d+)\) ?: ([a-z ]*(?:error|warning)) (.*))");
    static const std::regex colons(R"((ERROR|WARNING): 0:(\d+): *(?:(?:error|warning)\b:? *)?(.*))");
    const std::string line(log_line);
    std::smatch part;
    if (std::regex_match(line, part, mesa))
        return make_complaint(source.location(number(part[1])), number(part[2]), part[3], part[4]);
    if (std::regex_match(line, part, nvidia))
        return make_complaint(source.location(number(part[1])), 0, part[2], part[3]);
    if (std::regex_match(line, part, colons))
        return make_complaint(source.location(number(part[2])), 0, lower_case(part[1]), part[3]);
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
