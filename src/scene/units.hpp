#pragma once
// The units that a light's quantity may be stated in.
#include "core/error.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

namespace sr::scene {

/// The system of units of a scene's light: lumens and the units derived from them (glTF), or watts.
enum class UnitSystem { photometric, radiometric };

/// The quantity that is stated of a light: Φ, I, E or L.
enum class Quantity { flux, intensity, irradiance, radiance };

struct Unit {
    Quantity quantity = Quantity::radiance;
    UnitSystem system = UnitSystem::photometric;

    bool operator==(const Unit&) const = default;
};

struct NamedUnit {
    std::string_view name;
    Unit unit;
};

/// All names that are understood; a unit's first name is the one that we write.
inline constexpr std::array<NamedUnit, 12> unit_names{{
    {"lm", {Quantity::flux, UnitSystem::photometric}},
    {"cd", {Quantity::intensity, UnitSystem::photometric}},
    {"lx", {Quantity::irradiance, UnitSystem::photometric}},
    {"cd/m^2", {Quantity::radiance, UnitSystem::photometric}},
    {"cd/m²", {Quantity::radiance, UnitSystem::photometric}},
    {"nit", {Quantity::radiance, UnitSystem::photometric}},
    {"W", {Quantity::flux, UnitSystem::radiometric}},
    {"W/sr", {Quantity::intensity, UnitSystem::radiometric}},
    {"W/m^2", {Quantity::irradiance, UnitSystem::radiometric}},
    {"W/m²", {Quantity::irradiance, UnitSystem::radiometric}},
    {"W/(m^2 sr)", {Quantity::radiance, UnitSystem::radiometric}},
    {"W/(m² sr)", {Quantity::radiance, UnitSystem::radiometric}},
}};

/// Absent: there is no such unit.
inline std::optional<Unit> unit_named(std::string_view name) {
    const auto found = std::find_if(unit_names.begin(), unit_names.end(),
                                    [&](const NamedUnit& entry) { return entry.name == name; });
    return found == unit_names.end() ? std::nullopt : std::optional(found->unit);
}

/// "lm", "W/(m^2 sr)", …, in ASCII.
inline std::string_view name_of(Unit unit) {
    const auto found = std::find_if(unit_names.begin(), unit_names.end(),
                                    [&](const NamedUnit& entry) { return entry.unit == unit; });
    require(found != unit_names.end(), "every unit has a name");
    return found->name;
}

/// The unit of a scene's radiance, and so of its film: "cd/m^2" or "W/(m^2 sr)".
inline std::string_view radiance_unit(UnitSystem system) { return name_of({Quantity::radiance, system}); }

/// Converts a quantity to a system in which a watt counts `efficacy` lumens [lm/W].
inline double converted(double value, UnitSystem from, UnitSystem to, double efficacy) {
    if (from == to) return value;
    return to == UnitSystem::photometric ? value * efficacy : value / efficacy;
}

} // namespace sr::scene
