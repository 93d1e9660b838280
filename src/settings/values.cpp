#include "settings/values.hpp"

#include <algorithm>
#include <charconv>
#include <climits>
#include <cmath>
#include <cstdlib>
#include <fmt/format.h>
#include <string_view>
#include <vector>

namespace sr::settings {
namespace {

/// Reads a whole number from `min` to `max`.
std::optional<int> parse_whole(std::string_view text, int min, int max) {
    int value = 0;
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (failure != std::errc{} || end != text.data() + text.size() || value < min || value > max)
        return std::nullopt;
    return value;
}

/// Reads a finite number.
std::optional<float> parse_float(const std::string& text) {
    char* end = nullptr;
    const float value = std::strtof(text.c_str(), &end);
    if (text.empty() || *end != '\0' || !std::isfinite(value)) return std::nullopt;
    return value;
}

} // namespace

std::optional<double> parse_number(const std::string& text) {
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    if (text.empty() || *end != '\0' || !std::isfinite(value)) return std::nullopt;
    return value;
}

std::optional<Size> parse_size(const std::string& text) {
    const auto cross = text.find('x');
    if (cross == std::string::npos) return std::nullopt;
    const auto width = parse_whole(std::string_view(text).substr(0, cross), 1, 65536);
    const auto height = parse_whole(std::string_view(text).substr(cross + 1), 1, 65536);
    if (!width || !height) return std::nullopt;
    return Size{*width, *height};
}

std::optional<FrameRange> parse_frames(const std::string& text) {
    const auto colon = text.find(':');
    if (colon == std::string::npos) return std::nullopt;
    const auto first = parse_whole(std::string_view(text).substr(0, colon), 0, INT_MAX);
    if (!first) return std::nullopt;
    if (colon + 1 == text.size()) return FrameRange{*first, std::nullopt};
    const auto last = parse_whole(std::string_view(text).substr(colon + 1), *first, INT_MAX);
    if (!last) return std::nullopt;
    return FrameRange{*first, last};
}

std::optional<vec3> parse_color(const std::string& text) {
    std::vector<float> numbers;
    for (std::size_t begin = 0; begin <= text.size();) {
        const auto comma = std::min(text.find(',', begin), text.size());
        const auto number = parse_float(text.substr(begin, comma - begin));
        if (!number) return std::nullopt;
        numbers.push_back(*number);
        begin = comma + 1;
    }
    if (numbers.size() == 1) return vec3(numbers[0]);
    if (numbers.size() == 3) return vec3(numbers[0], numbers[1], numbers[2]);
    return std::nullopt;
}

std::optional<double> parse_percentage(const std::string& text) {
    if (!text.ends_with('%')) return std::nullopt;
    const auto number = parse_float(text.substr(0, text.size() - 1));
    if (!number || *number <= 0.0f || *number >= 100.0f) return std::nullopt;
    return 0.01 * static_cast<double>(*number);
}

std::optional<double> parse_duration(const std::string& text) {
    const auto unit = std::min(text.find_first_of("sm"), text.size());
    const auto number = parse_float(text.substr(0, unit));
    const std::string_view name = std::string_view(text).substr(unit);
    if (!number || *number <= 0.0f || (!name.empty() && name != "s" && name != "min")) return std::nullopt;
    return (name == "min" ? 60.0 : 1.0) * static_cast<double>(*number);
}

std::string text_of(Size size) { return fmt::format("{}x{}", size.width, size.height); }

std::string text_of(FrameRange frames) {
    return fmt::format("{}:{}", frames.first, frames.last ? std::to_string(*frames.last) : "");
}

std::string text_of(vec3 color) {
    if (color.r == color.g && color.g == color.b) return fmt::format("{}", color.r);
    return fmt::format("{},{},{}", color.r, color.g, color.b);
}

std::string percentage_text(double share) { return fmt::format("{}%", static_cast<float>(100.0 * share)); }

std::string duration_text(double seconds) { return fmt::format("{}s", static_cast<float>(seconds)); }

} // namespace sr::settings
