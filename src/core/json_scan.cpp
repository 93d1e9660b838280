#include "core/json_scan.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

namespace sr {
namespace {

/// Calls visit(i) for each character outside of strings.
template<typename Visit>
void outside_strings(std::string_view text, Visit visit) {
    bool is_in_string = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '"')
            is_in_string = !is_in_string;
        else if (is_in_string)
            i += text[i] == '\\' ? 1 : 0;
        else
            visit(i);
    }
}

} // namespace

JsonExtent json_extent(std::string_view text) {
    JsonExtent extent;
    int depth = 0;
    outside_strings(text, [&](std::size_t i) {
        const char c = text[i];
        const bool opens = c == '{' || c == '[';
        extent.values += opens || c == ',';
        depth += opens - (c == '}' || c == ']');
        extent.depth = std::max(extent.depth, depth);
    });
    return extent;
}

std::optional<std::size_t> overflowing_number(std::string_view text) {
    constexpr std::string_view of_numbers = "+-.0123456789eE";
    std::optional<std::size_t> found;
    std::size_t end = 0;
    outside_strings(text, [&](std::size_t i) {
        const bool starts = text[i] == '-' || (text[i] >= '0' && text[i] <= '9');
        if (found || i < end || !starts) return;
        end = std::min(text.find_first_not_of(of_numbers, i), text.size());
        if (std::isinf(std::strtod(std::string(text.substr(i, end - i)).c_str(), nullptr))) found = i;
    });
    return found;
}

} // namespace sr
