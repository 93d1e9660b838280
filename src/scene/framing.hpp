#pragma once
// A camera for scenes that bring none.
#include "scene/scene.hpp"

namespace sr::scene {

/// Looks at the scene from the front, a little from the right and above (glTF: the front of an asset faces
/// +Z), as close as every vertex is in a picture of the given width / height, with a little air around.
Camera framing_camera(const Scene& scene, float aspect_ratio);

} // namespace sr::scene
