#pragma once
// Lights in words and numbers, for `steradian info`.
#include "scene/scene.hpp"

#include <nlohmann/json.hpp>
#include <string>

namespace sr::cli {

/// A light's kind, name, quantity as RGB, area, flux Φ (its luminance; a texture counts as white) and where
/// and how large it is. Each key names its unit, that of a radiometric scene if the scene is one.
nlohmann::ordered_json described(const scene::Light& light, const scene::Scene& scene);

/// A value as people read it: texts without quotes, numbers with six digits, lists in brackets.
std::string text_of(const nlohmann::ordered_json& value);

/// A described light in one line: "rectangle "panel": L [cd/m^2] (200, 200, 100), A [m^2] 2, …".
std::string line_of(const nlohmann::ordered_json& light);

} // namespace sr::cli
