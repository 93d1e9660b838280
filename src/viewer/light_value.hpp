#pragma once
// The quantity of a light as text, and the values that a person may type: "800 lm", "6500 K", "12 lx", "250",
// "+1 EV".
#include "scene/lights/light.hpp"
#include "scene/spectrum.hpp"

#include <span>
#include <string_view>

namespace sr::viewer {

/// Lights that are edited as one: a single light, or all surfaces of one emissive material. None is empty.
struct LightGroup {
    std::span<const scene::Light> lights;
    const std::vector<scene::LightProfile>& profiles;
    scene::UnitSystem units = scene::UnitSystem::photometric;
};

/// "2500 cd/m^2, 785 lm": its own quantity, and its flux where it has one; as luminances.
std::string value_text(const LightGroup& group);

/// The quantity as RGB after a person typed `text`: a number with one of scene::unit_names (none: the light's
/// own unit), which sets how much, or a number of kelvins with K, which sets the colour and keeps the
/// luminance.
/// "+1 EV" and "-0.5 EV" double and halve the quantity so often.
/// @throws Error that says what such a light takes
vec3 parse_quantity(std::string_view text, const LightGroup& group);

} // namespace sr::viewer
