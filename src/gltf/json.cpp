#include "gltf/json.hpp"

#include "core/json.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace sr::gltf {
namespace {

using nlohmann::json;

constexpr int max_depth = 128;

// nlohmann's text is "[json.exception…] parse error at line 3, column 5: <what>"; `what` may quote the file's
// bytes.
std::string description(const std::exception& error) {
    std::string text = error.what();
    const auto column = text.find("column ");
    const auto colon = column == std::string::npos ? text.find("] ") : text.find(": ", column);
    if (colon != std::string::npos) text.erase(0, colon + 2);
    constexpr std::size_t max_size = 160;
    if (text.size() > max_size) text = text.substr(0, max_size) + "…";
    std::replace_if(
        text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20; }, ' ');
    return text;
}

[[noreturn]] void fail(const JsonError& error, const Container& container, const std::string& name) {
    if (error.kind == JsonError::Kind::nesting)
        throw Error({name}, fmt::format("the JSON is nested deeper than {} levels", max_depth),
                    "flatten the extras or extensions that do so");
    const Location place = location_of(error.byte, container.json, name);
    if (container.json_offset == 0)
        throw Error(place,
                    fmt::format("{} ({})",
                                error.kind == JsonError::Kind::syntax ? "this is not valid JSON"
                                                                      : "the JSON cannot be read",
                                description(error)),
                    "correct it, or export the file again");
    throw Error(
        {name},
        fmt::format("the GLB's JSON is broken at byte {} of the file (line {}, column {} of the JSON; {})",
                    container.json_offset + error.byte, place.line, place.column, description(error)),
        "export the file again");
}

template<class Json>
Json parse_as(const Container& container, const std::string& name) {
    try {
        Json root = parse_json<Json>(container.json, max_depth, name);
        if (!root.is_object()) throw Error({name}, "the JSON is not an object", "give a glTF 2.0 file");
        return root;
    } catch (const JsonError& error) {
        fail(error, container, name);
    }
}

} // namespace

json parse(const Container& container, const std::string& name) { return parse_as<json>(container, name); }

nlohmann::ordered_json parse_ordered(const Container& container, const std::string& name) {
    return parse_as<nlohmann::ordered_json>(container, name);
}

} // namespace sr::gltf
