#include "gltf/schema.hpp"

#include "core/error.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace sr::gltf {
namespace {

using nlohmann::json;

// A value on the way down: `parent` chains make the JSON pointer only when an error needs it.
struct Place {
    const Place* parent = nullptr;
    std::string_view key{};
    std::size_t index = 0;

    std::string pointer() const {
        if (!parent) return "";
        return parent->pointer() + "/" + (key.data() ? std::string(key) : std::to_string(index));
    }
};

class Check {
public:
    Check(const json& root, const std::string& name) : root_(root), name_(name) {}

    void value(json& value, const Rule& rule, const Place& place) const {
        switch (rule.kind) {
        case Rule::Kind::anything: return;
        case Rule::Kind::boolean: return claim(value.is_boolean(), "must be true or false", value, place);
        case Rule::Kind::text: return text(value, rule, place);
        case Rule::Kind::number: return number(value, place);
        case Rule::Kind::whole: return whole(value, rule, place);
        case Rule::Kind::index: return index(value, rule, place);
        case Rule::Kind::list: return list(value, rule, place);
        case Rule::Kind::record: return record(value, rule, place);
        case Rule::Kind::dictionary: return dictionary(value, rule, place);
        }
    }

private:
    void claim(bool holds, std::string_view demand, const json& value, const Place& place) const {
        if (!holds) fail(demand, value, place);
    }

    [[noreturn]] void fail(std::string_view demand, const json& value, const Place& place) const {
        std::string shown = value.dump(-1, ' ', true, json::error_handler_t::replace);
        if (shown.size() > 40) shown = shown.substr(0, 40) + "…";
        const std::string pointer = place.parent ? place.pointer() : "the root";
        throw Error({name_}, fmt::format("{} {}, and is {}", pointer, demand, shown),
                    "correct that value, or export the file again");
    }

    void text(const json& value, const Rule& rule, const Place& place) const {
        claim(value.is_string(), "must be a string", value, place);
        if (rule.words.empty()) return;
        const std::string_view word = value.get_ref<const std::string&>();
        for (std::string_view allowed : rule.words)
            if (word == allowed) return;
        fail(fmt::format("must be one of {}", fmt::join(rule.words, ", ")), value, place);
    }

    void number(const json& value, const Place& place) const {
        claim(value.is_number(), "must be a number", value, place);
        claim(std::abs(value.get<double>()) <= std::numeric_limits<float>::max(), "must fit a 32-bit float",
              value, place);
    }

    void whole(json& value, const Rule& rule, const Place& place) const {
        if (value.is_number_float()) {
            const double real = value.get<double>();
            if (real >= 0.0 && real <= static_cast<double>(rule.largest) && std::floor(real) == real)
                value = static_cast<std::uint64_t>(real);
        }
        if (!value.is_number_unsigned() || value.get<std::uint64_t>() > rule.largest)
            fail(fmt::format("must be a whole number from 0 to {}", rule.largest), value, place);
        if (rule.values.empty()) return;
        for (std::uint64_t allowed : rule.values)
            if (value.get<std::uint64_t>() == allowed) return;
        fail(fmt::format("must be one of {}", fmt::join(rule.values, ", ")), value, place);
    }

    void index(json& value, const Rule& rule, const Place& place) const {
        whole(value, rule, place);
        const json::json_pointer pointer{std::string(rule.pool)};
        const std::size_t size = root_.contains(pointer) ? root_.at(pointer).size() : 0;
        if (value.get<std::uint64_t>() >= size)
            fail(fmt::format("must be below {}, the number of {}", size, rule.pool), value, place);
    }

    void list(json& value, const Rule& rule, const Place& place) const {
        claim(value.is_array(), "must be an array", value, place);
        if (rule.length != 0 && value.size() != rule.length)
            fail(fmt::format("must have {} elements", rule.length), value, place);
        for (std::size_t i = 0; i < value.size(); ++i) this->value(value[i], *rule.element, {&place, {}, i});
    }

    void record(json& value, const Rule& rule, const Place& place) const {
        if (rule.is_optional && !value.is_object()) return;
        claim(value.is_object(), "must be an object", value, place);
        for (const PropertyRule& property : rule.properties) {
            const auto found = value.find(property.name);
            if (found != value.end())
                this->value(*found, *property.rule, {&place, property.name, 0});
            else if (property.is_required)
                fail(fmt::format("must have the property \"{}\"", property.name), value, place);
        }
        if (rule.is_closed) no_others(value, rule, place);
    }

    void no_others(const json& value, const Rule& rule, const Place& place) const {
        std::vector<std::string_view> names;
        for (const PropertyRule& property : rule.properties) names.push_back(property.name);
        for (const auto& [key, ignored] : value.items())
            if (std::find(names.begin(), names.end(), key) == names.end())
                fail(fmt::format("may have {} only", fmt::join(names, ", ")), json{{key, value.at(key)}},
                     place);
    }

    void dictionary(json& value, const Rule& rule, const Place& place) const {
        claim(value.is_object(), "must be an object", value, place);
        for (auto& [key, element] : value.items()) this->value(element, *rule.element, {&place, key, 0});
    }

    const json& root_;
    const std::string& name_;
};

} // namespace

void check(json& root, const Rule& rule, const std::string& name) {
    Check(root, name).value(root, rule, Place{});
}

} // namespace sr::gltf
