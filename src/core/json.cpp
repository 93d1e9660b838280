#include "core/json.hpp"

#include "core/file.hpp"
#include "core/limits.hpp"
#include "core/text.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <system_error>

namespace sr {

namespace fs = std::filesystem;
using nlohmann::json;

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

template<class Json>
Json parse_json(std::string_view text, int max_depth, const std::string& name) {
    const JsonExtent extent = json_extent(text);
    check_limit(Limit::json_values, extent.values, name);
    if (extent.depth > max_depth) throw JsonError(JsonError::Kind::nesting, 0, "nested too deeply");
    try {
        return Json::parse(text.begin(), text.end());
    } catch (const json::parse_error& error) {
        throw JsonError(JsonError::Kind::syntax, error.byte > 0 ? error.byte - 1 : 0, error.what());
    } catch (const json::exception& error) {
        throw JsonError(JsonError::Kind::number, overflowing_number(text).value_or(0), error.what());
    }
}

template json parse_json<json>(std::string_view, int, const std::string&);
template nlohmann::ordered_json parse_json<nlohmann::ordered_json>(std::string_view, int, const std::string&);

Location location_of(std::size_t byte, std::string_view text, const std::string& file) {
    const std::string_view before = text.substr(0, std::min(byte, text.size()));
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    const auto line_start = before.rfind('\n') == std::string_view::npos ? 0 : before.rfind('\n') + 1;
    return {file, static_cast<int>(line), static_cast<int>(1 + before.size() - line_start)};
}

namespace {

constexpr int max_file_depth = 64; // no suite or assignment needs more

/// Walks a text that is known to be valid JSON.
class Walker {
public:
    explicit Walker(std::string_view text) : text_(text) { skip_space(); }

    std::size_t position() const { return at_; }
    /// Begin of the key of the member that was entered last; of an element, of its value.
    std::size_t key_position() const { return key_at_; }

    /// Moves to the member `key` of the object, or to the element `key` of the array, that begins here.
    bool enter(const std::string& key) {
        const bool is_object = text_[at_] == '{';
        if (!is_object && text_[at_] != '[') return false;
        ++at_;
        for (std::size_t index = 0; skip_space(), text_[at_] != '}' && text_[at_] != ']'; ++index) {
            std::string name = std::to_string(index);
            key_at_ = at_;
            if (is_object) {
                const std::size_t begin = at_;
                skip_string();
                name = json::parse(text_.substr(begin, at_ - begin)).get<std::string>();
                skip_to_value();
            }
            if (name == key) return true;
            skip_value();
            skip_space();
            if (text_[at_] == ',') ++at_;
        }
        return false;
    }

private:
    void skip_space() { at_ = std::min(text_.find_first_not_of(" \t\r\n", at_), text_.size()); }
    void skip_to_value() {
        at_ = text_.find(':', at_) + 1;
        skip_space();
    }
    void skip_string() {
        for (++at_; text_[at_] != '"'; ++at_)
            if (text_[at_] == '\\') ++at_;
        ++at_;
    }
    void skip_value() {
        int depth = 0;
        do {
            const char c = text_[at_];
            if (c == '"') {
                skip_string();
                continue;
            }
            if (c == '{' || c == '[') ++depth;
            if (c == '}' || c == ']') --depth;
            if (depth < 0) return; // the end of the container around a number or a word
            ++at_;
        } while (depth > 0
                 || (at_ < text_.size() && text_[at_] != ',' && text_[at_] != '}' && text_[at_] != ']'));
    }

    std::string_view text_;
    std::size_t at_ = 0;
    std::size_t key_at_ = 0;
};

/// A walker that has entered the value at a pointer, or as many of its parts as there are.
Walker walked(std::string_view text, const JsonFile::Pointer& pointer) {
    std::vector<std::string> keys;
    for (JsonFile::Pointer rest = pointer; !rest.empty(); rest.pop_back()) keys.push_back(rest.back());
    Walker walker(text);
    for (auto key = keys.rbegin(); key != keys.rend(); ++key)
        if (!walker.enter(*key)) break;
    return walker;
}

/// nlohmann's message without its own numbering: "syntax error while parsing value - unexpected …".
std::string reason(const JsonError& error) {
    const std::string text = error.what();
    const auto dash = text.find(" - ");
    const auto colon = text.find(": ");
    if (dash != std::string::npos) return text.substr(dash + 3);
    return colon != std::string::npos ? text.substr(colon + 2) : text;
}

} // namespace

JsonFile::JsonFile(const std::filesystem::path& file) : JsonFile(file, read_text(file)) {}

JsonFile::JsonFile(const std::filesystem::path& file, std::string text)
    : file_(file.string()), text_(std::move(text)) {
    try {
        root_ = parse_json<json>(text_, max_file_depth, file_);
    } catch (const JsonError& error) {
        if (error.kind == JsonError::Kind::nesting)
            throw Error({file_}, "nested deeper than 64 levels",
                        "write lists and objects within fewer others");
        const Location place = location_of(error.byte, text_, file_);
        if (error.kind == JsonError::Kind::number)
            throw Error(place, "a number that is too large", "write one below 1.8e308");
        throw Error(place, reason(error), "correct the JSON there");
    }
}

Location JsonFile::place_of(const Pointer& pointer) const {
    return location_of(walked(text_, pointer).position(), text_, file_);
}

Location JsonFile::place_of_key(const Pointer& pointer) const {
    return location_of(walked(text_, pointer).key_position(), text_, file_);
}

JsonObject::JsonObject(const JsonFile& file, Pointer place) : file_(&file), place_(std::move(place)) {
    if (!value().is_object())
        fail(fmt::format("{} where an object belongs", value().type_name()), "write { … }");
}

void JsonObject::fail(const std::string& what, const std::string& what_to_do) const {
    throw Error(file_->place_of(place_), what, what_to_do);
}

void JsonObject::fail_at(const std::string& key, const std::string& what,
                         const std::string& what_to_do) const {
    throw Error(file_->place_of(place_ / key), what, what_to_do);
}

std::string JsonObject::text(const std::string& key, const std::string& fallback) const {
    if (!has(key)) return fallback;
    const json& member = value().at(key);
    if (!member.is_string())
        fail_at(key, fmt::format("\"{}\" is a {}", key, member.type_name()),
                "write a text in quotation marks");
    refuse_nul(key, member);
    return member.get<std::string>();
}

void JsonObject::refuse_nul(const std::string& key, const json& text) const {
    if (text.get_ref<const std::string&>().find('\0') != std::string::npos)
        fail_at(key, fmt::format("\"{}\" has a NUL character, where the system ends a text", key),
                "leave it out");
}

fs::path JsonObject::path(const std::string& key, const std::string& text, const fs::path& folder) const {
    const fs::path file = folder / text;
    std::error_code failure;
    [[maybe_unused]] const fs::file_status status = fs::status(file, failure);
    if (failure == std::errc::filename_too_long || failure == std::errc::too_many_symbolic_link_levels)
        fail_at(key, fmt::format("{} is no path ({})", shorten(text, 60), failure.message()),
                "name a file or folder that can be there");
    return file;
}

std::string JsonObject::required_text(const std::string& key) const {
    if (!has(key)) fail(fmt::format("\"{}\" is missing", key), fmt::format("add \"{}\": \"…\"", key));
    return text(key, "");
}

double JsonObject::number(const std::string& key, double fallback, double low, double high) const {
    if (!has(key)) return fallback;
    const json& member = value().at(key);
    if (!member.is_number() || !(member.get<double>() >= low && member.get<double>() <= high))
        fail_at(key, fmt::format("\"{}\" is {}", key, member.dump()),
                fmt::format("write a number from {} to {}", low, high));
    return member.get<double>();
}

int JsonObject::integer(const std::string& key, int fallback, int low, int high) const {
    const double found = number(key, fallback, low, high);
    if (found != std::floor(found))
        fail_at(key, fmt::format("\"{}\" is {}", key, found),
                fmt::format("write a whole number from {} to {}", low, high));
    return static_cast<int>(found);
}

bool JsonObject::flag(const std::string& key, bool fallback) const {
    if (!has(key)) return fallback;
    if (!value().at(key).is_boolean())
        fail_at(key, fmt::format("\"{}\" is a {}", key, value().at(key).type_name()), "write true or false");
    return value().at(key).get<bool>();
}

std::vector<std::string> JsonObject::texts(const std::string& key) const {
    if (!has(key)) return {};
    const json& member = value().at(key);
    if (member.is_string()) return {text(key, "")};
    if (!member.is_array() || !std::ranges::all_of(member, [](const json& e) { return e.is_string(); }))
        fail_at(key, fmt::format("\"{}\" is no list of texts", key), "write [\"…\", \"…\"]");
    for (const json& element : member) refuse_nul(key, element);
    return member.get<std::vector<std::string>>();
}

std::vector<double> JsonObject::numbers(const std::string& key, std::size_t count) const {
    if (!has(key))
        fail(fmt::format("\"{}\" is missing", key), fmt::format("add a list of {} numbers", count));
    const json& member = value().at(key);
    if (!member.is_array() || member.size() != count
        || !std::ranges::all_of(member, [](const json& e) { return e.is_number(); }))
        fail_at(key, fmt::format("\"{}\" is {}", key, member.dump()),
                fmt::format("write a list of {} numbers", count));
    return member.get<std::vector<double>>();
}

std::vector<JsonObject> JsonObject::objects(const std::string& key) const {
    std::vector<JsonObject> result;
    if (!has(key)) return result;
    const json& member = value().at(key);
    if (!member.is_array())
        fail_at(key, fmt::format("\"{}\" is a {}", key, member.type_name()), "write [ … ]");
    for (std::size_t i = 0; i < member.size(); ++i) result.emplace_back(*file_, place_ / key / i);
    return result;
}

void JsonObject::allow_only(const std::vector<const char*>& keys) const {
    for (const auto& [key, member] : value().items())
        if (std::ranges::find(keys, key) == keys.end())
            fail_at(key, fmt::format("unknown key \"{}\"", key),
                    fmt::format("known here are {}", fmt::join(keys, ", ")));
}

} // namespace sr
