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

class Checker {
public:
    Checker(const json& root, const std::string& name, Warnings& warnings)
        : root_(root), name_(name), warnings_(warnings) {}

    std::set<std::string> lost; // JSON pointers

    void value(json& value, const Schema& schema, const Place& place) {
        if (!schema.is_ours) return check(value, schema, place);
        try {
            check(value, schema, place);
        } catch (const Error& error) {
            throw OurFault(error);
        }
    }

private:
    void check(json& value, const Schema& schema, const Place& place) {
        switch (schema.kind) {
        case Schema::Kind::anything: return;
        case Schema::Kind::boolean: return demand(value.is_boolean(), "must be true or false", value, place);
        case Schema::Kind::string: return string(value, schema, place);
        case Schema::Kind::number: return number(value, place);
        case Schema::Kind::integer: return integer(value, schema, place);
        case Schema::Kind::index: return index(value, schema, place);
        case Schema::Kind::array: return array(value, schema, place);
        case Schema::Kind::object: return object(value, schema, place);
        case Schema::Kind::dictionary: return dictionary(value, schema, place);
        }
    }

    /// Checks a value that may be a thing. @return whether it is to be removed
    bool is_lost(json& value, const Schema& schema, const Place& place) {
        if (schema.loss.empty()) {
            this->value(value, schema, place);
            return false;
        }
        try {
            this->value(value, schema, place);
            return false;
        } catch (const OurFault&) {
            throw;
        } catch (const Error& error) {
            warnings_.add_loss(error, schema.loss);
        }
        lost.insert(place.pointer());
        if (!schema.stand_in.empty()) value = json::parse(schema.stand_in);
        return schema.stand_in.empty();
    }

    void demand(bool holds, std::string_view requirement, const json& value, const Place& place) const {
        if (!holds) fail(requirement, value, place);
    }

    [[noreturn]] void fail(std::string_view requirement, const json& value, const Place& place) const {
        std::string shown = value.dump(-1, ' ', true, json::error_handler_t::replace);
        if (shown.size() > 40) shown = shown.substr(0, 40) + "…";
        const std::string pointer = place.parent ? place.pointer() : "the root";
        throw Error({name_}, fmt::format("{} {}, and is {}", pointer, requirement, shown),
                    "correct that value, or export the file again");
    }

    void string(const json& value, const Schema& schema, const Place& place) const {
        demand(value.is_string(), "must be a string", value, place);
        if (schema.enum_values.empty()) return;
        const std::string_view word = value.get_ref<const std::string&>();
        for (std::string_view allowed : schema.enum_values)
            if (word == allowed) return;
        fail(fmt::format("must be one of {}", fmt::join(schema.enum_values, ", ")), value, place);
    }

    void number(const json& value, const Place& place) const {
        demand(value.is_number(), "must be a number", value, place);
        demand(std::abs(value.get<double>()) <= std::numeric_limits<float>::max(), "must fit a 32-bit float",
               value, place);
    }

    void integer(json& value, const Schema& schema, const Place& place) const {
        if (value.is_number_float()) {
            const double real = value.get<double>();
            if (real >= 0.0 && real <= static_cast<double>(schema.maximum) && std::floor(real) == real)
                value = static_cast<std::uint64_t>(real);
        }
        if (!value.is_number_unsigned() || value.get<std::uint64_t>() > schema.maximum)
            fail(fmt::format("must be a whole number from 0 to {}", schema.maximum), value, place);
        if (schema.enum_integers.empty()) return;
        for (std::uint64_t allowed : schema.enum_integers)
            if (value.get<std::uint64_t>() == allowed) return;
        fail(fmt::format("must be one of {}", fmt::join(schema.enum_integers, ", ")), value, place);
    }

    void index(json& value, const Schema& schema, const Place& place) const {
        integer(value, schema, place);
        const json::json_pointer pointer{std::string(schema.indexes_into)};
        const std::size_t size = root_.contains(pointer) ? root_.at(pointer).size() : 0;
        if (value.get<std::uint64_t>() >= size)
            fail(fmt::format("must be below {}, the number of {}", size, schema.indexes_into), value, place);
    }

    void array(json& value, const Schema& schema, const Place& place) {
        demand(value.is_array(), "must be an array", value, place);
        if (schema.length != 0 && value.size() != schema.length)
            fail(fmt::format("must have {} elements", schema.length), value, place);
        std::size_t kept = 0;
        for (std::size_t i = 0; i < value.size(); ++i) {
            if (is_lost(value[i], *schema.items, {&place, {}, i})) continue;
            if (kept != i) value[kept] = std::move(value[i]);
            ++kept;
        }
        while (value.size() > kept) value.erase(value.size() - 1);
    }

    void object(json& value, const Schema& schema, const Place& place) {
        if (schema.is_optional && !value.is_object()) return;
        demand(value.is_object(), "must be an object", value, place);
        for (const PropertySchema& property : schema.properties) {
            const auto found = value.find(property.name);
            if (found != value.end()) {
                if (is_lost(*found, *property.schema, {&place, property.name, 0})) value.erase(found);
            } else if (property.is_required)
                fail(fmt::format("must have the property \"{}\"", property.name), value, place);
        }
        if (!schema.additional_properties) forbid_others(value, schema, place);
    }

    void forbid_others(const json& value, const Schema& schema, const Place& place) const {
        std::vector<std::string_view> names;
        for (const PropertySchema& property : schema.properties) names.push_back(property.name);
        for (const auto& [key, ignored] : value.items())
            if (std::find(names.begin(), names.end(), key) == names.end())
                fail(fmt::format("may have {} only", fmt::join(names, ", ")), json{{key, value.at(key)}},
                     place);
    }

    void dictionary(json& value, const Schema& schema, const Place& place) {
        demand(value.is_object(), "must be an object", value, place);
        for (auto& [key, element] : value.items()) this->value(element, *schema.items, {&place, key, 0});
    }

    const json& root_;
    const std::string& name_;
    Warnings& warnings_;
};

} // namespace

std::set<std::string> check(json& root, const Schema& schema, const std::string& name, Warnings& warnings) {
    Checker checker(root, name, warnings);
    checker.value(root, schema, Place{});
    return std::move(checker.lost);
}

} // namespace sr::gltf
