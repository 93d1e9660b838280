#pragma once
// glTF cameras.
#include "gltf/hierarchy.hpp"
#include "scene/camera.hpp"

namespace sr::gltf {

/// The camera of a placed node, without the node's scale. Its name is the camera's, or else the node's.
/// @throws Error if the projection makes no sense
scene::Camera camera_at(const Document& document, const PlacedNode& placed);

} // namespace sr::gltf
