#include "cli/arguments.hpp"

#include "core/output.hpp"
#include "glsl/root.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>

namespace sr::cli {
namespace {

std::optional<int> parsed_extent(std::string_view text) {
    int value = 0;
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (failure != std::errc{} || end != text.data() + text.size() || value < 1 || value > 65536)
        return std::nullopt;
    return value;
}

std::optional<float> parsed_number(const std::string& text) {
    char* end = nullptr;
    const float value = std::strtof(text.c_str(), &end);
    if (text.empty() || *end != '\0' || !std::isfinite(value)) return std::nullopt;
    return value;
}

} // namespace

Size picture_size(std::optional<float> aspect_ratio) {
    constexpr int rows = 720;
    const float aspect = aspect_ratio.value_or(16.0f / 9.0f);
    return {std::clamp(static_cast<int>(std::lround(rows * aspect)), 1, 16 * rows), rows};
}

std::optional<Size> parsed_size(const std::string& text) {
    const auto cross = text.find('x');
    if (cross == std::string::npos) return std::nullopt;
    const auto width = parsed_extent(std::string_view(text).substr(0, cross));
    const auto height = parsed_extent(std::string_view(text).substr(cross + 1));
    if (!width || !height) return std::nullopt;
    return Size{*width, *height};
}

std::string refusal_of_number(const std::string& text) {
    return std::isfinite(std::strtod(text.c_str(), nullptr)) ? "" : "'" + text + "' is not a finite number";
}

std::optional<vec3> parsed_color(const std::string& text) {
    std::vector<float> numbers;
    for (std::size_t begin = 0; begin <= text.size();) {
        const auto comma = std::min(text.find(',', begin), text.size());
        const auto number = parsed_number(text.substr(begin, comma - begin));
        if (!number) return std::nullopt;
        numbers.push_back(*number);
        begin = comma + 1;
    }
    if (numbers.size() == 1) return vec3(numbers[0]);
    if (numbers.size() == 3) return vec3(numbers[0], numbers[1], numbers[2]);
    return std::nullopt;
}

std::optional<double> parsed_percentage(const std::string& text) {
    if (!text.ends_with('%')) return std::nullopt;
    const auto number = parsed_number(text.substr(0, text.size() - 1));
    if (!number || *number <= 0.0f || *number >= 100.0f) return std::nullopt;
    return 0.01 * static_cast<double>(*number);
}

std::optional<double> parsed_duration(const std::string& text) {
    const auto unit = std::min(text.find_first_of("sm"), text.size());
    const auto number = parsed_number(text.substr(0, unit));
    const std::string_view name = std::string_view(text).substr(unit);
    if (!number || *number <= 0.0f || (!name.empty() && name != "s" && name != "min")) return std::nullopt;
    return (name == "min" ? 60.0 : 1.0) * static_cast<double>(*number);
}

std::vector<glsl::Root> shader_path(const std::vector<std::string>& folders, bool is_untrusted) {
    std::vector<glsl::Root> path;
    for (const std::string& folder : folders) {
        const glsl::Root root = glsl::Root::folder(folder);
        path.push_back(is_untrusted ? root.untrusted() : root);
    }
    path.push_back(glsl::embedded());
    for (const std::string& folder : folders)
        if (const auto remark = glsl::remark_on_overlay(folder, path.back(), folders)) write_remark(*remark);
    return path;
}

} // namespace sr::cli
