#pragma once
// Materials in words.
#include "scene/material.hpp"

#include <string>

namespace sr::scene {

/// Describes the BRDF: "metallic_roughness, clearcoat, sheen".
std::string described(const Material& material);

} // namespace sr::scene
