#include "gltf/json.hpp"

#include "core/error.hpp"
#include "core/json_scan.hpp"
#include "core/limits.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace sr::gltf {
namespace {

using nlohmann::json;

constexpr int deepest = 128;

// nlohmann's text is "[json.exception…] parse error at line 3, column 5: <what>"; `what` may quote the file's
// bytes.
std::string description(const std::exception& error) {
    std::string text = error.what();
    const auto column = text.find("column ");
    const auto colon = column == std::string::npos ? text.find("] ") : text.find(": ", column);
    if (colon != std::string::npos) text.erase(0, colon + 2);
    constexpr std::size_t longest = 160;
    if (text.size() > longest) text = text.substr(0, longest) + "…";
    std::replace_if(
        text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20; }, ' ');
    return text;
}

[[noreturn]] void fail_at(std::size_t byte, const char* what, const std::exception& error,
                          const Container& container, const std::string& name) {
    const std::string_view before = container.json.substr(0, byte > 0 ? byte - 1 : 0);
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    const auto line_start = before.rfind('\n') == std::string_view::npos ? 0 : before.rfind('\n') + 1;
    const auto column = 1 + before.size() - line_start;
    if (container.json_offset == 0)
        throw Error({name, static_cast<int>(line), static_cast<int>(column)},
                    fmt::format("{} ({})", what, description(error)), "correct it, or export the file again");
    throw Error(
        {name},
        fmt::format("the GLB's JSON is broken at byte {} of the file (line {}, column {} of the JSON; {})",
                    container.json_offset + before.size(), line, column, description(error)),
        "export the file again");
}

template<class Json>
Json parse_as(const Container& container, const std::string& name) {
    const JsonExtent extent = json_extent(container.json);
    check_limit(Limit::json_values, extent.values, name);
    if (extent.depth > deepest)
        throw Error({name}, fmt::format("the JSON is nested deeper than {} levels", deepest),
                    "flatten the extras or extensions that do so");
    try {
        Json root = Json::parse(container.json.begin(), container.json.end());
        if (!root.is_object()) throw Error({name}, "the JSON is not an object", "give a glTF 2.0 file");
        return root;
    } catch (const json::parse_error& error) {
        fail_at(error.byte, "this is not valid JSON", error, container, name);
    } catch (const json::exception& error) { // a number that fits no double
        fail_at(overflowing_number(container.json).value_or(0) + 1, "the JSON cannot be read", error,
                container, name);
    }
}

} // namespace

json parse(const Container& container, const std::string& name) { return parse_as<json>(container, name); }

nlohmann::ordered_json parse_ordered(const Container& container, const std::string& name) {
    return parse_as<nlohmann::ordered_json>(container, name);
}

} // namespace sr::gltf
