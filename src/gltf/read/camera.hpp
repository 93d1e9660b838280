#pragma once
// glTF cameras.
#include "gltf/read/nodes.hpp"
#include "scene/camera.hpp"

namespace sr::gltf {

/// The camera of a transform node, without the node's scale. Its name is the camera's, or else the node's.
/// @throws Error if the projection makes no sense
scene::Camera parse_camera(const Document& document, const NodeTransform& transform);

} // namespace sr::gltf
