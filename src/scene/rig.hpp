#pragma once
// Light for scenes that bring none.
#include "scene/scene.hpp"

namespace sr::scene {

/// Three softboxes (key, fill, rim) around `subject` as a photographer at `camera` would place them:
/// rectangles that scale with the subject, hidden from the camera. They give about 1000, 500 and 800 lx at
/// the subject's centre.
std::vector<RectangleLight> studio_rig(const Bounds& subject, const Camera& camera);

} // namespace sr::scene
