#pragma once
// Lights as the JSON of a glTF file states them.
#include "gltf/write/edited_copy.hpp"

#include <nlohmann/json.hpp>

namespace sr::gltf {

/// The 16 numbers of a node's matrix.
nlohmann::ordered_json matrix_json(const glm::dmat4& matrix);

/// Replaces the emission that an object of extras.steradian states.
void state_emission(nlohmann::ordered_json& steradian, const StatedEmission& emission);

/// Returns the node of a light that the file does not have. A point, a spot or a directional light becomes a
/// light of KHR_lights_punctual in `gltf`, all others a shape of extras.steradian.
/// @param origin of the scene in the file's world (Scene::origin)
/// @throws Error for a light that needs other parts of its scene
nlohmann::ordered_json light_node(const AddedLight& added, glm::dvec3 origin, nlohmann::ordered_json& gltf);

} // namespace sr::gltf
