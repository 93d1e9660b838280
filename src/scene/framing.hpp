#pragma once
// A camera for scenes that bring none.
#include "scene/scene.hpp"

namespace sr::scene {

/// Looks at `subject` from the front, a little from the right and above (glTF: the front of an asset faces
/// +Z), from so far that the whole box is in the picture of the given width / height.
Camera framing_camera(const Bounds& subject, float aspect_ratio);

} // namespace sr::scene
