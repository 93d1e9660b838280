#pragma once
// Values of options, with their texts.
#include "core/math.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace sr::settings {

/// Row of a table of the names of an enumeration.
template<class T>
struct NamedValue {
    std::string_view name;
    T value;
};

/// Returns the name of a value in an array of NamedValue; empty if it has none.
template<class Table, class T>
constexpr std::string_view name_in(const Table& table, const T& value) {
    for (const auto& row : table)
        if (row.value == value) return row.name;
    return {};
}

struct Size {
    int width = 0;
    int height = 0;
};

/// Frames from the first to the last, both included; up to the end of the animation if the last is absent.
struct FrameRange {
    int first = 0;
    std::optional<int> last;
};

/// Reads a finite number; absent for any other text.
std::optional<double> parse_number(const std::string& text);

/// Reads "1280x720"; absent if it is not two whole numbers from 1 to 65536.
std::optional<Size> parse_size(const std::string& text);

/// Reads "0:47" or "12:"; absent if it is neither.
std::optional<FrameRange> parse_frames(const std::string& text);

/// Reads "0.1,0.2,0.3" or a single number for all three; absent if it is neither, or not finite.
std::optional<vec3> parse_color(const std::string& text);

/// Reads "0.5%" as 0.005; absent if it is not a percentage above 0 and below 100.
std::optional<double> parse_percentage(const std::string& text);

/// Reads "2", "2s", "1.5min" [s]; absent if it is not above 0.
std::optional<double> parse_duration(const std::string& text);

/// Texts that the functions above read as these values.
std::string text_of(Size size);
std::string text_of(FrameRange frames);
std::string text_of(vec3 color);
std::string percentage_text(double share);
std::string duration_text(double seconds);

} // namespace sr::settings
