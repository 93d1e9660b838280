#include "core/text.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace sr {
namespace {

/// The code point of a valid UTF-8 sequence.
char32_t code_point(std::string_view sequence) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(sequence[i]); };
    if (sequence.size() == 1) return byte(0);
    char32_t code = byte(0) & (0xFFu >> (sequence.size() + 1));
    for (std::size_t i = 1; i < sequence.size(); ++i) code = code << 6 | (byte(i) & 0x3Fu);
    return code;
}

bool is_control(char32_t code) {
    return code < 0x20 || (code >= 0x7F && code < 0xA0) || code == 0x061C || code == 0x200E || code == 0x200F
           || (code >= 0x2028 && code <= 0x202E) || (code >= 0x2066 && code <= 0x2069) || code == 0xFEFF;
}

/// Replaces what `escape` has an answer for; an answer that is empty leaves the character as it is.
template<typename Escape>
std::string escaped(std::string_view text, Escape escape) {
    std::string result;
    result.reserve(text.size());
    while (!text.empty()) {
        const std::size_t length = utf8_length(text);
        const std::string_view sequence = text.substr(0, std::max<std::size_t>(length, 1));
        const std::string replacement = escape(sequence, length > 0);
        if (replacement.empty())
            result += sequence;
        else
            result += replacement;
        text.remove_prefix(sequence.size());
    }
    return result;
}

std::string escape_of(std::string_view sequence, bool is_valid) {
    if (!is_valid) return fmt::format("\\x{:02x}", static_cast<unsigned char>(sequence[0]));
    const char32_t code = code_point(sequence);
    if (!is_control(code)) return {};
    if (code == '\n') return "\\n";
    if (code == '\r') return "\\r";
    if (code == '\t') return "\\t";
    return code < 0x80 ? fmt::format("\\x{:02x}", static_cast<unsigned>(code))
                       : fmt::format("\\u{:04x}", static_cast<unsigned>(code));
}

} // namespace

std::size_t utf8_length(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char lead = byte(0);
    if (lead < 0x80) return 1;
    const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
    if (lead < 0xC2 || lead > 0xF4 || text.size() < length) return 0;
    for (std::size_t i = 1; i < length; ++i)
        if ((byte(i) & 0xC0) != 0x80) return 0;
    if (lead == 0xE0 && byte(1) < 0xA0) return 0; // longer than needed
    if (lead == 0xED && byte(1) > 0x9F) return 0; // surrogates
    if (lead == 0xF0 && byte(1) < 0x90) return 0;
    if (lead == 0xF4 && byte(1) > 0x8F) return 0; // above U+10FFFF
    return length;
}

bool is_control(std::string_view text, std::size_t length) {
    return is_control(code_point(text.substr(0, length)));
}

std::string with_plain_breaks(std::string text) {
    std::size_t size = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '\r' && i + 1 < text.size() && text[i + 1] == '\n') continue;
        text[size++] = text[i] == '\r' ? '\n' : text[i];
    }
    text.resize(size);
    return text;
}

std::string shown(std::string_view text) { return escaped(text, escape_of); }

std::string shown_lines(std::string_view text) {
    return escaped(text, [](std::string_view sequence, bool is_valid) {
        return sequence == "\n" || sequence == "\t" ? std::string() : escape_of(sequence, is_valid);
    });
}

std::string shown_json(std::string_view json) {
    return escaped(json, [](std::string_view sequence, bool is_valid) {
        if (sequence == "\n" || !is_valid || !is_control(code_point(sequence))) return std::string();
        return fmt::format("\\u{:04x}", static_cast<unsigned>(code_point(sequence)));
    });
}

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view blanks = " \t\r\n";
    const auto first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::string one_line(std::string_view message) {
    while (!message.empty() && (message.back() == '\n' || message.back() == '.')) message.remove_suffix(1);
    std::string line(message.empty() ? "no reason given" : message);
    for (char& c : line)
        if (c == '\n' || c == '\r') c = ' ';
    return line;
}

std::string shorten(std::string_view text, std::size_t size) {
    if (text.size() <= size) return std::string(text);
    while (size > 0 && (static_cast<unsigned char>(text[size]) & 0xC0) == 0x80) --size;
    return std::string(text.substr(0, size)) + "…";
}

} // namespace sr
