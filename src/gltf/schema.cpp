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

/// A fault in what is addressed to this program.
struct OurFault : Error {
    explicit OurFault(const Error& error) : Error(error) {}
};

class Check {
public:
    Check(const json& root, const std::string& name, Warnings& warnings)
        : root_(root), name_(name), warnings_(warnings) {}

    std::set<std::string> lost; // JSON pointers

    void value(json& value, const Rule& rule, const Place& place) {
        if (!rule.is_ours) return obey(value, rule, place);
        try {
            obey(value, rule, place);
        } catch (const Error& error) {
            throw OurFault(error);
        }
    }

private:
    void obey(json& value, const Rule& rule, const Place& place) {
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

    /// Checks a value that may be a thing. @return whether it is to be removed
    bool is_lost(json& value, const Rule& rule, const Place& place) {
        if (rule.loss.empty()) {
            this->value(value, rule, place);
            return false;
        }
        try {
            this->value(value, rule, place);
            return false;
        } catch (const OurFault&) {
            throw;
        } catch (const Error& error) {
            warnings_.add_loss(error, rule.loss);
        }
        lost.insert(place.pointer());
        if (!rule.stand_in.empty()) value = json::parse(rule.stand_in);
        return rule.stand_in.empty();
    }

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

    void list(json& value, const Rule& rule, const Place& place) {
        claim(value.is_array(), "must be an array", value, place);
        if (rule.length != 0 && value.size() != rule.length)
            fail(fmt::format("must have {} elements", rule.length), value, place);
        std::size_t kept = 0;
        for (std::size_t i = 0; i < value.size(); ++i) {
            if (is_lost(value[i], *rule.element, {&place, {}, i})) continue;
            if (kept != i) value[kept] = std::move(value[i]);
            ++kept;
        }
        while (value.size() > kept) value.erase(value.size() - 1);
    }

    void record(json& value, const Rule& rule, const Place& place) {
        if (rule.is_optional && !value.is_object()) return;
        claim(value.is_object(), "must be an object", value, place);
        for (const PropertyRule& property : rule.properties) {
            const auto found = value.find(property.name);
            if (found != value.end()) {
                if (is_lost(*found, *property.rule, {&place, property.name, 0})) value.erase(found);
            } else if (property.is_required)
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

    void dictionary(json& value, const Rule& rule, const Place& place) {
        claim(value.is_object(), "must be an object", value, place);
        for (auto& [key, element] : value.items()) this->value(element, *rule.element, {&place, key, 0});
    }

    const json& root_;
    const std::string& name_;
    Warnings& warnings_;
};

} // namespace

std::set<std::string> check(json& root, const Rule& rule, const std::string& name, Warnings& warnings) {
    Check check(root, name, warnings);
    check.value(root, rule, Place{});
    return std::move(check.lost);
}

} // namespace sr::gltf
