#pragma once
// Names of an enumeration's values: a table for parsing, printing and help.
#include <string_view>

namespace sr {

template<class T>
struct Named {
    std::string_view name;
    T value;
};

/// Returns the name of a value in an array of Named; empty if it has none.
template<class Table, class T>
constexpr std::string_view name_in(const Table& table, const T& value) {
    for (const auto& row : table)
        if (row.value == value) return row.name;
    return {};
}

} // namespace sr
