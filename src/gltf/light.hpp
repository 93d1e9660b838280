#pragma once
// KHR_lights_punctual, and EXT_lights_area (area_light.cpp).
#include "gltf/hierarchy.hpp"
#include "gltf/warnings.hpp"
#include "scene/light.hpp"

#include <vector>

namespace sr::gltf {

/// Appends the lights that a placed node carries, in world space. They keep their photometric numbers
/// whatever the node's scale is; only the size of an area light scales.
/// @throws Error naming a light with a negative quantity, a bad cone or no size
void append_lights(const Document& document, const PlacedNode& placed, std::vector<scene::Light>& lights,
                   Warnings& warnings);

/// The same for EXT_lights_area alone.
void append_area_light(const Document& document, const PlacedNode& placed, std::vector<scene::Light>& lights,
                       Warnings& warnings);

/// What errors call a light: "light "Key" (/extensions/…/lights/0)".
std::string light_title(std::string_view extension, int index, std::string_view name);

/// The unit direction that a node's -Z points to in the world. @throws Error naming the light if its node has
/// no depth
vec3 direction_of(const Document& document, const PlacedNode& placed, const std::string& title);

/// Colour times quantity. @throws Error if either is negative
vec3 emitted_color(const Document& document, glm::dvec3 color, double quantity, const std::string& title);

} // namespace sr::gltf
