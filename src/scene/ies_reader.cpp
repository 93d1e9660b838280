#include "scene/ies_reader.hpp"

#include "core/error.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/format.h>

namespace sr::scene {
namespace {

bool is_separator(char c) { return c == ' ' || c == '\t' || c == ',' || c == '\r' || c == '\n' || c == '\0'; }

/// A word of the file in quotes, fit for a message.
std::string shown(std::string_view word) {
    constexpr std::size_t longest = 40;
    std::string text = "\"";
    for (const char c : word.substr(0, longest)) text += c >= 0x20 && c < 0x7F ? c : '?';
    return text + (word.size() > longest ? "…\"" : "\"");
}

} // namespace

std::string_view IesReader::line() {
    const std::size_t end = std::min(text_.find('\n'), text_.size());
    std::string_view line = text_.substr(0, end);
    text_.remove_prefix(std::min(end + 1, text_.size()));
    line_ = next_line_++;
    if (line.ends_with('\r')) line.remove_suffix(1);
    return line;
}

void IesReader::skip_separators() {
    while (!text_.empty() && is_separator(text_.front())) {
        next_line_ += text_.front() == '\n';
        text_.remove_prefix(1);
    }
}

bool IesReader::has_more() {
    skip_separators();
    constexpr char dos_end = 0x1A; // ends text files of DOS
    return !text_.empty() && text_.front() != dos_end;
}

double IesReader::number(std::string_view what) {
    const bool is_there = has_more();
    line_ = next_line_;
    if (!is_there) fail(fmt::format("the file ends where {} should be", what), "get the whole file");
    const auto end = std::find_if(text_.begin(), text_.end(), is_separator);
    const std::string_view word(text_.begin(), end);
    text_.remove_prefix(word.size());
    const std::string_view digits = word.starts_with('+') ? word.substr(1) : word;
    double value = 0.0;
    const auto [stop, failure] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (failure != std::errc{} || stop != digits.data() + digits.size() || !std::isfinite(value))
        fail(fmt::format("{} is {}, no number", what, shown(word)), "correct it");
    return value;
}

int IesReader::whole(std::string_view what, int smallest, int largest) {
    const double value = number(what);
    if (value != std::floor(value) || value < smallest || value > largest)
        fail(fmt::format("{} is {}", what, value),
             fmt::format("it must be a whole number from {} to {}", smallest, largest));
    return static_cast<int>(value);
}

void IesReader::fail(std::string_view what, std::string_view what_to_do) const {
    throw Error({name_, line_}, what, what_to_do);
}

} // namespace sr::scene
