#pragma once
// The terms of a pixel as a question of an examination has them, and why a light adds nothing there.
#include "render/probe.hpp"
#include "scene/prepare.hpp"

#include <nlohmann/json.hpp>
#include <string>

namespace sr::assignment {

/// "(0.1, 0.2, 0.3)".
std::string rgb_text(vec3 value);

/// "'lamp'", or "light 2" if it has no name.
std::string name_at(const scene::Light& light, std::size_t k);

/// {"x", "n", "L_e", "L_o", "lights": [{"name", "cos", "V", "E", "f_r", "L_r"}]}; E and f_r as luminance.
/// "cos" is cosθ towards the middle of the light; null for a light that is nowhere.
nlohmann::ordered_json terms_json(const scene::RenderScene& stage, const render::PixelTerms& terms);

/// Tells why light k adds nothing to a pixel, or that it should: `reference` has the reference's terms.
std::string reason_of_darkness(const scene::Light& light, std::size_t k, const render::PixelTerms& terms,
                               const render::PixelTerms& reference);

} // namespace sr::assignment
