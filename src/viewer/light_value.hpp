#pragma once
// What a light's quantity is, and what a person may type in its place: "800 lm", "6500 K", "12 lx", "250".
#include "scene/photometry.hpp"

#include <span>
#include <string_view>

namespace sr::viewer {

/// I, E or L of a light as RGB; a profile's factor.
vec3 quantity_of(const scene::Light& light);
void set_quantity(scene::Light& light, vec3 quantity);

/// In which of them the light keeps it. A profile's factor has no unit.
scene::Quantity kind_of(const scene::Light& light);
bool has_profile(const scene::Light& light);

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
/// @throws Error that says what such a light takes
vec3 typed_quantity(std::string_view text, const LightGroup& group);

/// Where a light is, for lights that are somewhere; the middle of its extent.
std::optional<vec3> center_of(const scene::Light& light);

/// Moves, turns and scales a light: points by the whole matrix, directions by its rotation, radii by the cube
/// root of its volume. A directional light only turns.
scene::Light transformed(scene::Light light, const mat4& by);

/// A box around the light's extent; around `least` metres for a point.
scene::Bounds bounds_of(const scene::Light& light, float least);

} // namespace sr::viewer
