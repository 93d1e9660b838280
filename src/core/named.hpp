#pragma once
// Names of an enumeration's values: a table for parsing, printing and help.
#include <optional>
#include <string_view>

namespace sr {

template<class T>
struct Named {
    std::string_view name;
    T value;
};

/// Returns the value of that name in an array of Named; absent if there is none.
template<class Table>
constexpr auto value_named(const Table& table, std::string_view name) {
    std::optional<decltype(table.front().value)> value;
    for (const auto& row : table)
        if (row.name == name) value = row.value;
    return value;
}

/// Returns the name of a value in an array of Named; empty if it has none.
template<class Table, class T>
constexpr std::string_view name_in(const Table& table, const T& value) {
    for (const auto& row : table)
        if (row.value == value) return row.name;
    return {};
}

} // namespace sr
