#pragma once
// Light for scenes that bring none.
#include "scene/scene.hpp"

namespace sr::scene {

/// A photographer's studio around the scene, as `camera` sees it: a key panel to its left, a fill panel to
/// its right, two strips behind the subject, a ceiling, and a room that darkens from there to the floor. It
/// is an environment, so that what is smooth has something to reflect wherever it looks. White that faces the
/// camera and a little upwards is 1 cd/m²; cameras do not see the studio.
EnvironmentLight studio(const Camera& camera);

/// Three softboxes (key, fill, rim) around `subject` as a photographer at `camera` would place them:
/// rectangles that scale with the subject, hidden from the camera. They give about 1000, 500 and 800 lx at
/// the subject's centre.
std::vector<RectangleLight> softbox_rig(const Bounds& subject, const Camera& camera);

} // namespace sr::scene
