#include "core/markup.hpp"

#include "core/text.hpp"

#include <algorithm>
#include <array>

namespace sr {
namespace {

constexpr std::string_view replacement = "\xEF\xBF\xBD"; // U+FFFD

std::string_view entity(char c) {
    switch (c) {
    case '&': return "&amp;";
    case '<': return "&lt;";
    case '>': return "&gt;";
    case '"': return "&quot;";
    case '\'': return "&#39;";
    default: return {};
    }
}

} // namespace

std::string escape_markup(std::string_view text) {
    std::string result;
    while (!text.empty()) {
        const std::size_t length = utf8_length(text);
        const char c = text.front();
        const bool is_control = static_cast<unsigned char>(c) < 0x20 && c != '\t' && c != '\n' && c != '\r';
        if (length == 0 || is_control)
            result += replacement;
        else if (const auto named = entity(c); !named.empty())
            result += named;
        else
            result += text.substr(0, length);
        text.remove_prefix(std::max<std::size_t>(length, 1));
    }
    return result;
}

std::string csv_cell(std::string_view text) {
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

} // namespace sr
