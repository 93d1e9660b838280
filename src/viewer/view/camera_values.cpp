#include "viewer/view/camera_values.hpp"

#include "core/error.hpp"
#include "core/text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

namespace sr::viewer {
namespace {

constexpr double film_height = 24.0; // [mm] of a frame of 36 mm × 24 mm

constexpr std::array<std::pair<std::string_view, double>, 6> length_units{
    {{"m", 1.0}, {"cm", 0.01}, {"mm", 0.001}, {"km", 1000.0}, {"ft", 0.3048}, {"in", 0.0254}}};

/// A number, and the word that follows it.
struct Quantified {
    double number = 0.0;
    std::string unit;
};

/// Splits "1, 2 cm 3" into numbers with their units; absent if it is something else.
std::optional<std::vector<Quantified>> quantities_in(std::string_view text) {
    std::vector<Quantified> found;
    const auto is_gap = [](char c) { return c == ' ' || c == ',' || c == ';' || c == '\t'; };
    while (true) {
        while (!text.empty() && is_gap(text.front())) text.remove_prefix(1);
        if (text.empty()) return found;
        Quantified next;
        if (text.front() == '+') text.remove_prefix(1);
        const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), next.number);
        if (failure != std::errc{} || !std::isfinite(next.number)) return std::nullopt;
        text.remove_prefix(static_cast<std::size_t>(end - text.data()));
        while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
        const auto is_of_unit = [&](char c) {
            return !is_gap(c) && !(c >= '0' && c <= '9') && c != '-' && c != '.';
        };
        const auto unit_end = std::ranges::find_if_not(text, is_of_unit);
        next.unit = std::string(text.begin(), unit_end);
        text.remove_prefix(static_cast<std::size_t>(unit_end - text.begin()));
        found.push_back(std::move(next));
    }
}

std::optional<double> metres_in(const std::string& unit) {
    const auto known = std::ranges::find(length_units, unit, &std::pair<std::string_view, double>::first);
    return known == length_units.end() ? std::nullopt : std::optional(known->second);
}

[[noreturn]] void refuse(std::string_view text, const char* what, const char* remedy) {
    throw Error(fmt::format("'{}' {}", trimmed(text), what), remedy);
}

} // namespace

glm::dvec3 parse_point(std::string_view text) {
    constexpr auto remedy = "write three numbers, if wanted with m, cm, mm, km, ft or in: 1.2, 0, 350 cm";
    const auto numbers = quantities_in(text);
    if (!numbers || numbers->size() != 3) refuse(text, "is no point", remedy);
    // A unit at the end alone is that of all three.
    const bool is_common = (*numbers)[0].unit.empty() && (*numbers)[1].unit.empty();
    glm::dvec3 point(0.0);
    for (int i = 0; i < 3; ++i) {
        const Quantified& number = (*numbers)[static_cast<std::size_t>(i)];
        const std::string& unit = is_common ? numbers->back().unit : number.unit;
        const auto metres = metres_in(unit.empty() ? "m" : unit);
        if (!metres) refuse(text, "has a unit that is no length", remedy);
        point[i] = number.number * *metres;
    }
    return point;
}

double parse_length(std::string_view text) {
    constexpr auto remedy = "write a number, if wanted with m, cm, mm, km, ft or in: 2.5 m";
    const auto numbers = quantities_in(text);
    if (!numbers || numbers->size() != 1) refuse(text, "is no length", remedy);
    const std::string& unit = numbers->front().unit;
    const auto metres = metres_in(unit.empty() ? "m" : unit);
    if (!metres) refuse(text, "has a unit that is no length", remedy);
    return numbers->front().number * *metres;
}

double parse_field_of_view(std::string_view text) {
    constexpr auto remedy = "write degrees, radians or a focal length in mm: 40 deg, 0.7 rad, 50 mm";
    const auto numbers = quantities_in(text);
    if (!numbers || numbers->size() != 1) refuse(text, "is no field of view", remedy);
    const auto& [number, unit] = numbers->front();
    double angle = 0.0;
    if (unit.empty() || unit == "deg" || unit == "°")
        angle = number * std::numbers::pi / 180.0;
    else if (unit == "rad")
        angle = number;
    else if (unit == "mm" && number > 0.0)
        angle = 2.0 * std::atan(0.5 * film_height / number);
    else
        refuse(text, "is no field of view", remedy);
    if (!(angle > 0.0 && angle < std::numbers::pi)) refuse(text, "is not between 0 and 180 degrees", remedy);
    return angle;
}

std::string text_of_point(glm::dvec3 point) {
    return fmt::format("{:.7g}, {:.7g}, {:.7g} m", point.x, point.y, point.z);
}
std::string text_of_length(double length) { return fmt::format("{:.7g} m", length); }
std::string text_of_field_of_view(double angle) {
    return fmt::format("{:.6g} deg", angle * 180.0 / std::numbers::pi);
}

} // namespace sr::viewer
