#pragma once
// The emission of a light that extras.steradian states: its quantity and its colour.
#include "gltf/document.hpp"
#include "scene/spectrum.hpp"
#include "scene/units.hpp"

#include <functional>
#include <optional>
#include <string>

namespace sr::gltf {

/// Returns the system that asset.extras.steradian.units states: photometric unless it is "radiometric".
scene::UnitSystem unit_system_of(const Document& document);

struct PhotometricValue {
    double value = 0.0; // >= 0
    scene::Unit unit;
};

struct EmissionSpec {
    std::optional<PhotometricValue> quantity;
    std::optional<scene::LightColor> color; // by colour, temperature or spectrum

    /// Returns the quantity and the colour that are stated here, each from `other` where it is not.
    EmissionSpec over(const EmissionSpec& other) const {
        return {quantity ? quantity : other.quantity, color ? color : other.color};
    }
};

/// The "quantity" and the "color", "temperature" or "spectrum" of an object; nothing for a null.
/// @throws Error calling its owner `title`, for a negative quantity, a temperature or a spectrum that is none
EmissionSpec parse_emission(const Document& document, const json* object, const std::string& title);

/// A light's own quantity (I, E or L) from a stated one in the scene's units; absent where that is not
/// determined.
using Conversion = std::function<std::optional<double>(scene::Quantity, double)>;

/// I, E or L as RGB. Where a quantity is stated, the light has this quantity, whatever its colour: colours
/// are taken at luminance 1. Where only a colour is, the luminance of `own` (glTF's colour times intensity)
/// stays.
/// @throws Error if the conversion is absent; `takes` says in which units such a light can be stated
vec3 emitted(const Document& document, const EmissionSpec& emission, glm::dvec3 own,
             const Conversion& conversion, const std::string& title, std::string_view takes);

/// The numbers of a light as 32-bit floats. @throws Error if they are too large for that
vec3 as_floats(const Document& document, glm::dvec3 rgb, const std::string& title);

/// Returns colour times quantity. @throws Error if either is negative
glm::dvec3 emitted_color(const Document& document, glm::dvec3 color, double quantity,
                         const std::string& title);

} // namespace sr::gltf
