#pragma once
// The rules of extras.steradian: what glTF cannot say of lights and materials. Their published form is
// assets/extras.schema.json, and a test holds the two together.
#include "gltf/schema.hpp"

namespace sr::gltf {

/// Rules for the `extras` of a node, of a light of KHR_lights_punctual, of a material and of the asset.
/// Extras that are no objects, or have no "steradian", pass: they are somebody else's.
const Rule& node_extras_rule();
const Rule& light_extras_rule();
const Rule& material_extras_rule();
const Rule& scene_extras_rule();
const Rule& asset_extras_rule();

} // namespace sr::gltf
