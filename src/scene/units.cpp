#include "scene/units.hpp"

#include "core/error.hpp"

#include <algorithm>

namespace sr::scene {

std::optional<Unit> unit_named(std::string_view name) {
    const auto found = std::find_if(unit_names.begin(), unit_names.end(),
                                    [&](const NamedUnit& entry) { return entry.name == name; });
    return found == unit_names.end() ? std::nullopt : std::optional(found->unit);
}

std::string_view name_of(Unit unit) {
    const auto found = std::find_if(unit_names.begin(), unit_names.end(),
                                    [&](const NamedUnit& entry) { return entry.unit == unit; });
    require(found != unit_names.end(), "every unit has a name");
    return found->name;
}

double converted(double value, UnitSystem from, UnitSystem to, double efficacy) {
    if (from == to) return value;
    return to == UnitSystem::photometric ? value * efficacy : value / efficacy;
}

} // namespace sr::scene
