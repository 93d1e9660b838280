#include "golden/suite_reader.hpp"

#include "core/text.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <system_error>

namespace sr::golden {

namespace fs = std::filesystem;
using nlohmann::json;

SuiteReader::SuiteReader(const JsonText& text, Pointer place) : text_(&text), place_(std::move(place)) {
    if (!value().is_object())
        fail(fmt::format("{} where an object belongs", value().type_name()), "write { … }");
}

void SuiteReader::fail(const std::string& what, const std::string& what_to_do) const {
    throw Error(text_->place_of(place_), what, what_to_do);
}

void SuiteReader::fail_at(const std::string& key, const std::string& what,
                          const std::string& what_to_do) const {
    throw Error(text_->place_of(place_ / key), what, what_to_do);
}

std::string SuiteReader::text(const std::string& key, const std::string& fallback) const {
    if (!has(key)) return fallback;
    const json& member = value().at(key);
    if (!member.is_string())
        fail_at(key, fmt::format("\"{}\" is a {}", key, member.type_name()),
                "write a text in quotation marks");
    refuse_nul(key, member);
    return member.get<std::string>();
}

void SuiteReader::refuse_nul(const std::string& key, const json& text) const {
    if (text.get_ref<const std::string&>().find('\0') != std::string::npos)
        fail_at(key, fmt::format("\"{}\" has a NUL character, where the system ends a text", key),
                "leave it out");
}

fs::path SuiteReader::path(const std::string& key, const std::string& text, const fs::path& folder) const {
    const fs::path file = folder / text;
    std::error_code failure;
    [[maybe_unused]] const fs::file_status status = fs::status(file, failure);
    if (failure == std::errc::filename_too_long || failure == std::errc::too_many_symbolic_link_levels)
        fail_at(key, fmt::format("{} is no path ({})", shortened(text, 60), failure.message()),
                "name a file or folder that can be there");
    return file;
}

std::string SuiteReader::required_text(const std::string& key) const {
    if (!has(key)) fail(fmt::format("\"{}\" is missing", key), fmt::format("add \"{}\": \"…\"", key));
    return text(key, "");
}

double SuiteReader::number(const std::string& key, double fallback, double low, double high) const {
    if (!has(key)) return fallback;
    const json& member = value().at(key);
    if (!member.is_number() || !(member.get<double>() >= low && member.get<double>() <= high))
        fail_at(key, fmt::format("\"{}\" is {}", key, member.dump()),
                fmt::format("write a number from {} to {}", low, high));
    return member.get<double>();
}

int SuiteReader::whole(const std::string& key, int fallback, int low, int high) const {
    const double found = number(key, fallback, low, high);
    if (found != std::floor(found))
        fail_at(key, fmt::format("\"{}\" is {}", key, found),
                fmt::format("write a whole number from {} to {}", low, high));
    return static_cast<int>(found);
}

bool SuiteReader::flag(const std::string& key, bool fallback) const {
    if (!has(key)) return fallback;
    if (!value().at(key).is_boolean())
        fail_at(key, fmt::format("\"{}\" is a {}", key, value().at(key).type_name()), "write true or false");
    return value().at(key).get<bool>();
}

std::vector<std::string> SuiteReader::texts(const std::string& key) const {
    if (!has(key)) return {};
    const json& member = value().at(key);
    if (member.is_string()) return {text(key, "")};
    if (!member.is_array() || !std::ranges::all_of(member, [](const json& e) { return e.is_string(); }))
        fail_at(key, fmt::format("\"{}\" is no list of texts", key), "write [\"…\", \"…\"]");
    for (const json& element : member) refuse_nul(key, element);
    return member.get<std::vector<std::string>>();
}

std::vector<double> SuiteReader::numbers(const std::string& key, std::size_t count) const {
    if (!has(key))
        fail(fmt::format("\"{}\" is missing", key), fmt::format("add a list of {} numbers", count));
    const json& member = value().at(key);
    if (!member.is_array() || member.size() != count
        || !std::ranges::all_of(member, [](const json& e) { return e.is_number(); }))
        fail_at(key, fmt::format("\"{}\" is {}", key, member.dump()),
                fmt::format("write a list of {} numbers", count));
    return member.get<std::vector<double>>();
}

std::vector<SuiteReader> SuiteReader::objects(const std::string& key) const {
    std::vector<SuiteReader> result;
    if (!has(key)) return result;
    const json& member = value().at(key);
    if (!member.is_array())
        fail_at(key, fmt::format("\"{}\" is a {}", key, member.type_name()), "write [ … ]");
    for (std::size_t i = 0; i < member.size(); ++i) result.emplace_back(*text_, place_ / key / i);
    return result;
}

void SuiteReader::allow_only(std::initializer_list<const char*> keys) const {
    for (const auto& [key, member] : value().items())
        if (std::ranges::find(keys, key) == keys.end())
            fail_at(key, fmt::format("unknown key \"{}\"", key),
                    fmt::format("known here are {}", fmt::join(keys, ", ")));
}

} // namespace sr::golden
